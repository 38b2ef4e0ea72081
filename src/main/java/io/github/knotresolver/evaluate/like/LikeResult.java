package io.github.knotresolver.evaluate.like;

import java.util.Arrays;
import java.util.List;
import java.util.OptionalDouble;
import java.util.function.ToDoubleFunction;
import java.util.function.ToIntFunction;
import java.util.stream.IntStream;

import org.apache.commons.math3.stat.descriptive.rank.Median;

import io.github.knotresolver.evaluate.CurveScore;
import io.github.knotresolver.evaluate.FrameScore;

/**
 * How often movies like the user's are resolved, and how exactly.
 *
 * @param source the user's result
 * @param motion what was simulated
 * @param traits of the user's movie
 * @param movies the simulated ones
 * @param seed that all began with
 */
public record LikeResult(LikeSource source, LikeMotion motion, LikeTraits traits,
	List<LikeMovie> movies, long seed) {

	public LikeResult {
		movies = List.copyOf(movies);
	}

	/**
	 * @return how many times as fast as in the model's default time runs in the
	 *         simulated movies; empty if the user's movie does not tell its frame
	 *         interval
	 */
	public OptionalDouble speed() {
		final OptionalDouble seconds = source.secondsPerFrame();
		return seconds.isPresent()
			? OptionalDouble.of(motion.interval() / seconds.getAsDouble())
			: OptionalDouble.empty();
	}

	/** @return the share of frames that are resolved */
	public ClusteredProportion resolved() {
		return ClusteredProportion.of(count(LikeMovie::resolved),
			count(m -> m.evaluation().frames().size()));
	}

	/** @return the same of the frames in which the filament meets or crosses itself */
	public ClusteredProportion knottedResolved() {
		return ClusteredProportion.of(count(LikeMovie::knottedResolved),
			count(LikeMovie::knottedFrames));
	}

	/** @return the same of the frames in which it crosses itself */
	public ClusteredProportion crossingResolved() {
		return ClusteredProportion.of(count(m -> crossing(m, true)),
			count(m -> crossing(m, false)));
	}

	private static int crossing(final LikeMovie movie, final boolean onlyResolved) {
		return (int) movie.evaluation().frames().stream()
			.filter(f -> f.crossings() > 0 && (!onlyResolved || f.score().isResolved())).count();
	}

	private int[] count(final ToIntFunction<LikeMovie> figure) {
		return movies.stream().mapToInt(figure).toArray();
	}

	/** @return all position errors of all movies, in pixels */
	public double[] positionErrors() {
		return movies.stream().flatMapToDouble(m -> Arrays.stream(m.evaluation().positionErrors()))
			.toArray();
	}

	/**
	 * @param figure a figure of a frame
	 * @return its values in all frames that have a contour
	 */
	public double[] scores(final ToDoubleFunction<CurveScore> figure) {
		return movies.stream().flatMap(m -> m.evaluation().frames().stream())
			.filter(FrameScore::present).map(FrameScore::score).mapToDouble(figure).toArray();
	}

	/**
	 * @param right whether frames that are resolved are asked for, or those that
	 *          have another contour
	 * @return the program's confidence in them
	 */
	public double[] confidence(final boolean right) {
		return movies.stream()
			.flatMapToDouble(m -> IntStream.range(0, m.confidence().size())
				.filter(i -> m.evaluation().frames().get(i).score().isResolved() == right)
				.mapToDouble(i -> m.confidence().get(i)))
			.filter(c -> !Double.isNaN(c)).toArray();
	}

	/**
	 * How well confidence tells right from wrong: the probability that a frame
	 * that is right has more of it than one that is wrong (area under the ROC curve).
	 *
	 * @return 0.5 for not at all, 1 for always; NaN if no frame is wrong, or none
	 *         right
	 */
	public double discrimination() {
		final double[] right = confidence(true), wrong = confidence(false);
		if (right.length == 0 || wrong.length == 0)
			return Double.NaN;
		double wins = 0;
		for (final double r : right)
			for (final double w : wrong)
				wins += r > w ? 1 : r == w ? 0.5 : 0;
		return wins / right.length / wrong.length;
	}

	/**
	 * @param quantity one of {@link LikeTraits#values()}
	 * @return its median over the simulated movies
	 */
	public double simulated(final String quantity) {
		return new Median().evaluate(
			movies.stream().mapToDouble(m -> m.traits().values().get(quantity)).toArray());
	}
}
