package io.github.knotresolver.track;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;

import java.util.List;
import java.util.OptionalDouble;
import java.util.function.IntToDoubleFunction;
import java.util.stream.IntStream;

import net.imglib2.img.array.ArrayImgs;

import org.junit.jupiter.api.Test;

import io.github.knotresolver.candidate.CandidateQuery;
import io.github.knotresolver.candidate.CandidateSet;
import io.github.knotresolver.candidate.TrailCandidates;
import io.github.knotresolver.fit.DrawnMovie;
import io.github.knotresolver.fit.LineModel;
import io.github.knotresolver.fit.NormalizedFrame;
import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.image.FrameEvidence;
import io.github.knotresolver.image.Pixels;
import io.github.knotresolver.model.Calibration;
import io.github.knotresolver.model.Movie;
import io.github.knotresolver.model.Polarity;
import io.github.knotresolver.progress.Progress;
import io.github.knotresolver.progress.Workers;
import io.github.knotresolver.skeleton.AppearanceFinder;
import io.github.knotresolver.skeleton.EvidenceFinder;

class FocusTest {

	private static final int FRAMES = 9, MIDDLE = FRAMES / 2;

	private static final double LENGTH = 70, USUAL = 2;

	/** A beating filament in frames whose lines are as wide as said. */
	private static List<FrameView> frames(final IntToDoubleFunction sigma) {
		final int size = DrawnMovie.SIZE;
		final float[] pixels = new float[size * size * FRAMES];
		for (int t = 0; t < FRAMES; t++) {
			final DrawnMovie one = DrawnMovie.draw(List.of(DrawnMovie.wave(t, LENGTH, 0.7)),
				List.of(), LineModel.uniform(LineModel.Kind.ADDITIVE, sigma.applyAsDouble(t), 1),
				0.04, t);
			System.arraycopy(Pixels.floats(one.movie().frame(0)), 0, pixels, t * size * size,
				size * size);
		}
		final Movie movie = new Movie("drawn", ArrayImgs.floats(pixels, size, size, FRAMES),
			Calibration.NONE);
		final EvidenceFinder finder = new EvidenceFinder(
			new AppearanceFinder(Workers.HERE, Progress.NONE)
				.find(movie, IntStream.rangeClosed(1, FRAMES).boxed().toList(), Polarity.BRIGHT)
				.appearance());
		return IntStream.range(0, FRAMES).mapToObj(t -> {
			final FrameEvidence evidence = finder.find(movie.frame(t));
			return new FrameView(t + 1,
				new NormalizedFrame(size, size, Pixels.doubles(movie.frame(t))), evidence);
		}).toList();
	}

	private static List<FrameView> known(final List<FrameView> frames) {
		final List<CandidateSet> sets = frames.stream()
			.map(f -> TrailCandidates.DEFAULT.generate(
				CandidateQuery.of(f.graph(), new Point(22.4, 55.3), OptionalDouble.empty()),
				Progress.NONE))
			.toList();
		return Focus.known(frames, sets);
	}

	@Test
	void whereFocusWandersEveryFrameSaysHowWideItsLinesAre() {
		final IntToDoubleFunction sigma = t -> USUAL + 0.15 * (t - MIDDLE);
		final List<FrameView> known = known(frames(sigma));
		for (int t = 1; t + 1 < FRAMES; t++)
			assertEquals(sigma.applyAsDouble(t) / USUAL, known.get(t).light().widening(), 0.1,
				"frame " + t);
	}

	@Test
	void inFocusNothingIsChanged() {
		final List<FrameView> frames = frames(t -> USUAL);
		assertSame(frames, known(frames));
	}
}
