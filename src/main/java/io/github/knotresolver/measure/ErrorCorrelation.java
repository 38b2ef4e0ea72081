
package io.github.knotresolver.measure;

import java.util.Collection;

import io.github.knotresolver.progress.Cancellation;

/**
 * How the errors of points are correlated that lie near each other on a contour.
 * Points of a contour that was traced pixel by pixel err almost independently;
 * those of a contour that was fitted to an image, or drawn as a spline, err
 * together over a few pixels.
 * <p>
 * It is found by matching: the residuals of the smoothing, pooled over all
 * contours of a movie, have an autocorrelation, and for any correlation of the
 * errors the autocorrelation that the smoothing would leave is known exactly,
 * because the smoothing is linear. Two shapes, exp(-d/range) as of a first-order
 * autoregressive process and exp(-d²/(2 range²)) as of a smooth fit, are tried
 * at ranges up to 0.35 of the window: what is smoother than that looks like
 * the filament itself and leaves no trace.
 *
 * @param gaussian whether it falls like a Gaussian, else exponentially
 * @param range in steps between points; 0 for independent errors
 */
record ErrorCorrelation(boolean gaussian, double range) {

	static final ErrorCorrelation NONE = new ErrorCorrelation(false, 0);

	/** Correlation of points that are {@code steps} apart. */
	double at(final double steps) {
		if (range == 0)
			return Math.abs(steps) < 0.5 ? 1 : 0;
		final double d = steps / range;
		return gaussian ? Math.exp(-d * d / 2) : Math.exp(-Math.abs(d));
	}

	/** Sum over all lags: how many points have one point's error. */
	double sum() {
		double sum = 1;
		for (int k = 1; k <= 8 * range + 1; k++)
			sum += 2 * at(k);
		return sum;
	}

	/** Whether the errors are known to come from a fit. */
	enum Kind {
		/** Nothing is known. */
		ANY(MeasureTuning.FIRST_RANGE, false, true),
		/** Smooth, over whatever range. */
		SMOOTH(MeasureTuning.FIRST_RANGE, true),
		/** Of a fit to an image: smooth over the image's blur at least. */
		FITTED(MeasureTuning.BLUR_RANGE, true);

		private final double shortest;
		private final boolean[] shapes;

		Kind(final double shortest, final boolean... shapes) {
			this.shortest = shortest;
			this.shapes = shapes;
		}
	}

	/**
	 * @param curves contours that were smoothed in the same way
	 * @param filter the smoothing's filter away from the ends
	 * @param kind what is known of the errors
	 * @return the correlation that explains their residuals best
	 */
	static ErrorCorrelation of(final Collection<SmoothedCurve> curves, final LocalFilter filter,
		final Kind kind) {
		final Residuals pooled = new Residuals(MeasureTuning.LAGS);
		for (final SmoothedCurve c : curves)
			c.addResiduals(pooled);
		final double[] seen = pooled.autocorrelation();
		if (pooled.count() < MeasureTuning.FEWEST_RESIDUALS || seen[0] == 0)
			return NONE;
		final double[] response = filter.residualResponse();
		ErrorCorrelation best = NONE;
		double least = kind == Kind.FITTED
			? Double.POSITIVE_INFINITY
			: mismatch(seen, NONE, response);
		for (double range = kind.shortest; range <= MeasureTuning.LONGEST_RANGE
			* filter.points(); range *= MeasureTuning.RANGE_STEP)
			for (final boolean gaussian : kind.shapes) {
				Cancellation.check();
				final ErrorCorrelation trial = new ErrorCorrelation(gaussian, range);
				final double mismatch = mismatch(seen, trial, response);
				if (mismatch < least) {
					least = mismatch;
					best = trial;
				}
			}
		return best;
	}

	/**
	 * @param response the filter's response correlated with itself, from lag
	 *          {@code 1 - n} to {@code n - 1}
	 */
	private static double mismatch(final double[] seen, final ErrorCorrelation rho,
		final double[] response) {
		double first = 0, sum = 0;
		for (int lag = 0; lag < seen.length; lag++) {
			double expected = 0;
			for (int l = 0; l < response.length; l++)
				expected += response[l] * rho.at(lag - (l - response.length / 2));
			if (lag == 0)
				first = expected;
			else
				sum += Math.pow(seen[lag] / seen[0] - expected / first, 2);
		}
		return sum;
	}

	/** Products of residuals that are some points apart, summed over contours. */
	static final class Residuals {

		private final double[] products;
		private final long[] pairs;

		/** @param lags number of lags, with lag 0 */
		Residuals(final int lags) {
			products = new double[lags];
			pairs = new long[lags];
		}

		/** Adds the residuals of points {@code from} to {@code to} (excluded). */
		void add(final double[] residual, final int from, final int to) {
			for (int lag = 0; lag < products.length; lag++)
				for (int i = from; i + lag < to; i++) {
					products[lag] += residual[i] * residual[i + lag];
					pairs[lag]++;
				}
		}

		/** @return number of residuals */
		long count() {
			return pairs[0];
		}

		/** @return mean product at each lag that has pairs */
		double[] autocorrelation() {
			int n = 0;
			while (n < products.length && pairs[n] > 0)
				n++;
			final double[] out = new double[Math.max(1, n)];
			for (int lag = 0; lag < n; lag++)
				out[lag] = products[lag] / pairs[lag];
			return out;
		}
	}
}
