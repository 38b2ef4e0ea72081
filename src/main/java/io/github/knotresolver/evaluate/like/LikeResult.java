package io.github.knotresolver.evaluate.like;

import java.util.Arrays;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.ToDoubleFunction;
import java.util.function.ToIntFunction;
import java.util.stream.IntStream;

import org.apache.commons.math3.stat.descriptive.rank.Median;

import io.github.knotresolver.evaluate.CurveScore;
import io.github.knotresolver.evaluate.Evaluation;
import io.github.knotresolver.evaluate.Evaluation.FrameScore;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.model.Movie;
import io.github.knotresolver.model.UserException;
import io.github.knotresolver.simulate.FilamentProperties;
import io.github.knotresolver.simulate.FilamentProperties.Clamp;
import io.github.knotresolver.simulate.MediumProperties;
import io.github.knotresolver.simulate.MotorProperties;
import io.github.knotresolver.simulate.Schedule;
import io.github.knotresolver.simulate.SimulationParameters;

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

	/**
	 * What is compared between the user's movie and the simulated ones, measured
	 * alike in both: in the user's along its resolved contours, in the simulated ones
	 * along the true ones.
	 *
	 * @param values by quantity with its unit, in the order of a table
	 */
	public record LikeTraits(Map<String, Double> values) {

		public LikeTraits {
			values = Collections.unmodifiableMap(new LinkedHashMap<>(values));
		}

		static LikeTraits of(final Movie movie, final List<Optional<Polyline>> contours,
			final Appearance look, final Motion motion) {
			final double size = movie.calibration().pixelSize();
			final String unit = movie.calibration().unit();
			final Map<String, Double> t = new LinkedHashMap<>();
			t.put("frames", (double) movie.size());
			t.put("frame interval [" + movie.calibration().timeUnit() + "]",
				movie.calibration().frameInterval());
			t.put("pixel size [" + unit + "]", size);
			t.put("length [" + unit + "]", size * new Median().evaluate(contours.stream()
				.flatMap(Optional::stream).mapToDouble(Polyline::length).toArray()));
			t.put("line width [px]", look.width());
			t.put("background [grey]", look.background());
			t.put("peak over background [grey]", look.peak());
			t.put("noise [grey]", look.noise());
			t.put("noise on the line [grey]", look.noiseOnLine());
			t.put("peak over noise", look.noise() > 0 ? look.peak() / look.noise() : Double.NaN);
			t.put("step of the tip [px]", motion.tipStep());
			t.put("step of the contour [px]", motion.contourStep());
			t.put("frames in which it meets itself [%]", 100 * motion.knotted());
			t.put("end to end over length", motion.extension());
			t.put("  at its straightest", motion.straightest());
			t.put("turning along it [turns]", motion.turning());
			return new LikeTraits(t);
		}
	}

	/**
	 * One simulated movie, resolved and scored.
	 *
	 * @param seed that it was simulated with
	 * @param evaluation the scores of its frames
	 * @param knotted for every frame, whether the filament meets or crosses itself
	 * @param confidence for every frame, how sure the program was; NaN without a
	 *          contour
	 * @param traits what it looks like and how it moves
	 * @param refusal why nothing was resolved, in one sentence; empty if it was
	 */
	public record LikeMovie(long seed, Evaluation evaluation, List<Boolean> knotted,
		List<Double> confidence, LikeTraits traits, Optional<String> refusal) {

		public LikeMovie {
			knotted = List.copyOf(knotted);
			confidence = List.copyOf(confidence);
		}

		/** @return number of frames that are resolved */
		public int resolved() {
			return count(false, true);
		}

		/** @return number of frames in which the filament meets or crosses itself */
		public int knottedFrames() {
			return count(true, false);
		}

		/** @return of these, the number that are resolved */
		public int knottedResolved() {
			return count(true, true);
		}

		private int count(final boolean onlyKnotted, final boolean onlyResolved) {
			int count = 0;
			for (int i = 0; i < knotted.size(); i++)
				if ((!onlyKnotted || knotted.get(i))
					&& (!onlyResolved || evaluation.frames().get(i).score().isResolved()))
					count++;
			return count;
		}
	}

	/**
	 * What to simulate, so that the motion resembles the user's.
	 *
	 * @param length of the filament in µm
	 * @param clamp how its first end is held
	 * @param density motors per µm²
	 * @param interval simulated time between frames in s. Where it differs from the
	 *          user's frame interval, the user's filament moves faster or slower than
	 *          the model's default: all rates and speeds are scaled alike, which is
	 *          the same as to scale time
	 * @param warmUp simulated time before the first frame in s
	 */
	public record LikeMotion(double length, Clamp clamp, double density, double interval,
		double warmUp) {

		/** Step of the integration in s, and its share of the interval. */
		private static final double LONGEST_STEP = 0.01, SHARE = 0.05, SHORTEST_STEP = 1e-4;

		/**
		 * @param frames number of frames
		 * @param seed start of the random numbers
		 * @return the simulation
		 * @throws UserException if there can be no such simulation, in one
		 *           sentence
		 */
		SimulationParameters simulation(final int frames, final long seed) {
			final FilamentProperties usual = FilamentProperties.microtubule(length);
			final double step = Math.max(SHORTEST_STEP, Math.min(LONGEST_STEP, SHARE * interval));
			return new SimulationParameters(
				new FilamentProperties(length, usual.persistenceLength(), usual.link(), clamp),
				MotorProperties.dynein(density), MediumProperties.WATER,
				new Schedule(frames * interval, frames, step, warmUp), seed);
		}
	}
}
