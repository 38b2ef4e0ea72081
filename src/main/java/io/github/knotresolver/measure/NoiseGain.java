
package io.github.knotresolver.measure;

import java.util.Arrays;

/**
 * What correlated errors do to smoothed values, relative to independent errors
 * of the same size: wᵀRw / wᵀw for the weights w of a filter and the
 * correlations R. It depends on where in its window a point lies, from the
 * middle (0) to the end (1), and is tabulated once for all contours.
 */
final class NoiseGain {

	private static final int PARTS = 8, DERIVATIVES = 3, CURVATURE = 2;

	private final ErrorCorrelation correlation;
	private final double[][] fitted = new double[DERIVATIVES][PARTS + 1];
	private final double[][] compared = new double[DERIVATIVES][PARTS + 1];
	private final double[] freedom = new double[PARTS + 1];
	private final double[] crossed = new double[PARTS + 1];

	/**
	 * @param order degree of the smoothing's polynomial
	 * @param points of a full window
	 * @param correlation of the errors
	 */
	NoiseGain(final int order, final int points, final ErrorCorrelation correlation) {
		this.correlation = correlation;
		final LocalFilter low = new LocalFilter(order, points),
			high = new LocalFilter(order + 2, Math.max(low.points(), order + 4));
		for (int k = 0; k <= PARTS; k++) {
			final int at = low.index(k / (double) PARTS), wide = high.index(k / (double) PARTS);
			final double[] size = sizes(low.points(), k > 0);
			freedom[k] = product(low.residual(at), low.residual(at), size);
			for (int d = 0; d < DERIVATIVES; d++) {
				final double[] w = low.weights(d, at);
				fitted[d][k] = gain(w, size);
				compared[d][k] = gain(more(low, high, d, at, wide), size);
			}
			final double[] w = low.weights(CURVATURE, at);
			crossed[k] = product(w, more(low, high, CURVATURE, at, wide), size) / square(w);
		}
	}

	/** What the higher order adds to the weights; nothing if its window is wider. */
	private static double[] more(final LocalFilter low, final LocalFilter high, final int d,
		final int at, final int wide) {
		return low.points() == high.points()
			? difference(high.weights(d, wide), low.weights(d, at))
			: new double[low.points()];
	}

	private static double[] difference(final double[] a, final double[] b) {
		final double[] out = new double[a.length];
		for (int i = 0; i < a.length; i++)
			out[i] = a[i] - b[i];
		return out;
	}

	/** Sizes of errors over a window, at the end of the contour or not. */
	private double[] sizes(final int points, final boolean end) {
		final double[] size = new double[points];
		for (int j = 0; j < points; j++) {
			final double d = (points - 1 - j) / Math.max(1e-9, correlation.range());
			size[j] = end && correlation.gaussian()
				? 1 + (MeasureTuning.LOOSE_END - 1) * Math.exp(-d * d / 2)
				: 1;
		}
		return size;
	}

	private double gain(final double[] w, final double[] size) {
		final double square = square(w);
		return square > 0 ? product(w, w, size) / square : 1;
	}

	private static double square(final double[] w) {
		return Arrays.stream(w).map(v -> v * v).sum();
	}

	/** Covariance of two filters' errors. */
	private double product(final double[] a, final double[] b, final double[] size) {
		double sum = 0;
		final int reach = Math.min(a.length - 1, (int) Math.ceil(8 * correlation.range()));
		for (int lag = -reach; lag <= reach; lag++) {
			double product = 0;
			for (int i = Math.max(0, -lag); i < Math.min(a.length, a.length - lag); i++)
				product += a[i] * size[i] * b[i + lag] * size[i + lag];
			sum += correlation.at(lag) * product;
		}
		return sum;
	}

	/**
	 * Covariance of the curvature and of its difference from the polynomial two
	 * orders higher, in variances of the curvature for independent errors.
	 */
	double ofProduct(final double part) {
		return at(crossed, part);
	}

	/** @return how many points have one point's error */
	double along() {
		return correlation.sum();
	}

	/** Of derivative {@code d} of the smoothed curve. */
	double ofFit(final int d, final double part) {
		return at(fitted[d], part);
	}

	/** Of its difference from the polynomial two orders higher. */
	double ofComparison(final int d, final double part) {
		return at(compared[d], part);
	}

	/** @return variance of a residual for errors of variance 1 */
	double freedom(final double part) {
		return Math.max(MeasureTuning.LEAST_FREEDOM, at(freedom, part));
	}

	private static double at(final double[] table, final double part) {
		final double k = PARTS * Math.min(1, part);
		final int i = Math.min(PARTS - 1, (int) k);
		return table[i] + (k - i) * (table[i + 1] - table[i]);
	}
}
