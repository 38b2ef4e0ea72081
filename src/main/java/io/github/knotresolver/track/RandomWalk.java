package io.github.knotresolver.track;

import java.util.Arrays;
import java.util.stream.IntStream;

import io.github.knotresolver.geometry.RobustStatistics;

/**
 * A quantity that is known in some frames and wanders from each frame to the next by
 * random steps, whose usual size is learned: none for what stays, small for a drift, large
 * for jitter. A jump at one frame stays a jump. What is known before and after a frame
 * gives its value there and how far that may be off (R. E. Kalman, doi:10.1115/1.3662552;
 * H. E. Rauch et al., doi:10.2514/3.3166). O(frames).
 *
 * @param mean the value in every frame
 * @param sd its standard deviation
 */
record RandomWalk(double[] mean, double[] sd) {

	/** Standard deviations of a step that are tried, as multiples of the noise. */
	private static final double[] STEPS = {0.05, 0.1, 0.2, 0.4, 0.8, 1.6, 3.2, 6.4};

	/**
	 * @param seen the value in each frame; NaN where it is not known, at least one known
	 * @param noise standard deviation of what is known, above 0, in each frame
	 */
	static RandomWalk through(final double[] seen, final double[] noise) {
		final int[] known = IntStream.range(0, seen.length).filter(t -> Double.isFinite(seen[t]))
			.toArray();
		if (known.length == 0)
			throw new IllegalArgumentException("A random walk needs at least one known value.");
		final double least = Arrays.stream(known).mapToDouble(t -> noise[t]).min().orElse(1);
		double best = Double.POSITIVE_INFINITY;
		double[] steps = {};
		for (final double step : STEPS) {
			final double[] variances = variances(seen, known, step * least, noise);
			final double price = new Filter(seen, variances, noise).price();
			if (price < best) {
				best = price;
				steps = variances;
			}
		}
		return robust(seen, steps, noise);
	}

	private static RandomWalk robust(final double[] seen, final double[] steps,
		final double[] noise) {
		final double[] believed = noise.clone();
		RandomWalk walk = new Filter(seen, steps, believed).smoothed();
		for (int round = 0; round < TrackTuning.WALK_ROUNDS; round++) {
			for (int t = 0; t < seen.length; t++)
				if (Double.isFinite(seen[t])) {
					final double off = Math.abs(seen[t] - walk.mean[t])
						/ (TrackTuning.WALK_OUTLIER / 2 * noise[t]);
					believed[t] = noise[t] * Math.max(1, off);
				}
			walk = new Filter(seen, steps, believed).smoothed();
		}
		return walk;
	}

	/** For every frame the variance of the step that leads to it: larger where there is a jump. */
	private static double[] variances(final double[] seen, final int[] known, final double step,
		final double[] noise) {
		final double[] variance = new double[seen.length];
		Arrays.fill(variance, step * step);
		for (int k = TrackTuning.JUMP_WINDOW; k <= known.length - TrackTuning.JUMP_WINDOW; k++) {
			final int from = known[k - 1], to = known[k];
			final double jump = median(seen, known, k)
				- median(seen, known, k - TrackTuning.JUMP_WINDOW);
			final double usual = step * step
				* (known[k + TrackTuning.JUMP_WINDOW - 1] - known[k - TrackTuning.JUMP_WINDOW])
				+ noise[from] * noise[from] + noise[to] * noise[to];
			if (jump * jump > TrackTuning.WALK_JUMP * TrackTuning.WALK_JUMP * usual)
				for (int t = from + 1; t <= to; t++)
					variance[t] = Math.max(variance[t], jump * jump);
		}
		return variance;
	}

	/** Of the known values from one on. */
	private static double median(final double[] seen, final int[] known, final int from) {
		return RobustStatistics
			.upperMedian(Arrays.stream(known, from, from + TrackTuning.JUMP_WINDOW)
				.mapToDouble(t -> seen[t]).toArray(), 0);
	}

	/** Forwards and backwards through time, with given steps. */
	private static final class Filter {

		private final double[] steps;
		private final double[] mean;
		private final double[] variance;
		private final double[] ahead;
		private double price;

		Filter(final double[] seen, final double[] steps, final double[] noise) {
			this.steps = steps;
			final int n = seen.length;
			mean = new double[n];
			variance = new double[n];
			ahead = new double[n];
			double m = 0, v = Double.POSITIVE_INFINITY;
			for (int t = 0; t < n; t++) {
				v += steps[t];
				ahead[t] = v;
				if (Double.isFinite(seen[t])) {
					final double r = noise[t] * noise[t], off = seen[t] - m;
					if (Double.isInfinite(v)) {
						m = seen[t];
						v = r;
					} else {
						final double expected = v + r;
						price += Math.min(TrackTuning.WALK_OUTLIER * TrackTuning.WALK_OUTLIER,
							off * off / expected) + Math.log(expected);
						m += v / expected * off;
						v = v * r / expected;
					}
				}
				mean[t] = m;
				variance[t] = v;
			}
		}

		/** Twice the negative logarithm of the likelihood of what is seen. */
		double price() {
			return price;
		}

		RandomWalk smoothed() {
			final int n = mean.length;
			final double[] settled = mean.clone(), sd = variance.clone();
			for (int t = n - 2; t >= 0; t--)
				if (Double.isInfinite(variance[t])) {
					settled[t] = settled[t + 1];
					sd[t] = sd[t + 1] + steps[t + 1];
				} else {
					final double gain = variance[t] / ahead[t + 1];
					settled[t] += gain * (settled[t + 1] - mean[t]);
					sd[t] += gain * gain * (sd[t + 1] - ahead[t + 1]);
				}
			for (int t = 0; t < n; t++)
				sd[t] = Math.sqrt(Math.max(0, sd[t]));
			return new RandomWalk(settled, sd);
		}
	}
}
