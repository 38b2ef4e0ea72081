package io.github.knotresolver.reproduction;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;

import net.imglib2.Cursor;
import net.imglib2.img.Img;
import net.imglib2.type.logic.BitType;

import io.github.knotresolver.evaluate.CurveScore;
import io.github.knotresolver.evaluate.SkeletonScore;
import io.github.knotresolver.geometry.Crossings;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.model.FrameStatus;
import io.github.knotresolver.model.Observation;
import io.github.knotresolver.model.Settings;
import io.github.knotresolver.model.UserException;
import io.github.knotresolver.progress.Progress;
import io.github.knotresolver.session.FrameSkeletons;
import io.github.knotresolver.session.Session;
import io.github.knotresolver.simulate.SimulatedMovie;

/** One method on one movie, judged frame by frame. */
final class Trial {

	private final Series series;
	private final Condition condition;
	private final Method method;
	private final SimulatedMovie movie;

	/** @param movie all frames; the condition says which of them are seen */
	Trial(final Series series, final Condition condition, final Method method,
		final SimulatedMovie movie) {
		this.series = series;
		this.condition = condition;
		this.method = method;
		this.movie = condition.of(movie);
	}

	/** @return a row for every frame that the method sees */
	List<FrameResult> run() {
		final Settings parameters = method.parameters(movie.movie(), movie.truth().get(0).first());
		return method.resolves() ? contours(parameters) : skeletons(parameters);
	}

	private List<FrameResult> skeletons(final Settings parameters) {
		final List<Img<BitType>> skeletons = FrameSkeletons.of(movie.movie(), parameters,
			Progress.NONE);
		final List<FrameResult> results = new ArrayList<>();
		for (int t = 0; t < skeletons.size(); t++) {
			final List<double[]> pixels = pixels(skeletons.get(t));
			final SkeletonScore score = SkeletonScore.of(movie.truth().get(t),
				pixels.stream().mapToDouble(p -> p[0]).toArray(),
				pixels.stream().mapToDouble(p -> p[1]).toArray());
			results.add(result(t, score.dice(), Double.NaN, score.errors()));
		}
		return results;
	}

	private static List<double[]> pixels(final Img<BitType> skeleton) {
		final List<double[]> pixels = new ArrayList<>();
		final Cursor<BitType> pixel = skeleton.localizingCursor();
		while (pixel.hasNext())
			if (pixel.next().get())
				pixels.add(pixel.positionAsDoubleArray());
		return pixels;
	}

	private List<FrameResult> contours(final Settings parameters) {
		final List<FrameResult> results = new ArrayList<>();
		for (final Observation frame : frames(parameters)) {
			final int t = frame.frame() - 1;
			results.add(frame.contour().filter(c -> c.length() > 0).map(c -> contour(t, c))
				.orElseGet(() -> result(t, 0, Double.POSITIVE_INFINITY, new double[0])));
		}
		return results;
	}

	/** What the pipeline finds; if it refuses the movie, nothing in any frame. */
	private List<Observation> frames(final Settings parameters) {
		try {
			return new Session(movie.movie(), parameters).solve(List.of(), Progress.NONE).only()
				.frames();
		} catch (final UserException e) {
			System.err.println(method.label() + " on " + series + ": " + e.getMessage());
			return IntStream.rangeClosed(1, movie.truth().size())
				.mapToObj(f -> Observation.without(f, FrameStatus.LOST, e.getMessage())).toList();
		}
	}

	private FrameResult contour(final int t, final Polyline contour) {
		final Polyline truth = movie.truth().get(t);
		final CurveScore score = CurveScore.of(truth, contour);
		return result(t, score.dice(), score.frechet(), CurveScore.positionErrors(truth, contour));
	}

	private FrameResult result(final int t, final double dice, final double frechet,
		final double[] errors) {
		return new FrameResult(series, condition, method, condition.original(t + 1),
			Crossings.of(movie.truth().get(t).resampled(1)).size(), dice, frechet, errors);
	}
}
