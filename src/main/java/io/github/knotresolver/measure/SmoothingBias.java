
package io.github.knotresolver.measure;

/**
 * How far smoothing pulls tangent angle and curvature from the truth. A
 * polynomial of two orders more in the same window has much less bias; the
 * squared difference of the two, less what noise alone would make of it (for
 * nested least squares the difference of the variances), averaged over a
 * window, estimates the squared bias.
 */
final class SmoothingBias {

	static final int ANGLE = 0;
	static final int CURVATURE = 1;

	private final Samples raw;
	private final double window;
	private final double[][] squares;
	private final double[][] excess;
	private final double[] curvatureDifference;
	private final double[][] shift;

	SmoothingBias(final Samples raw, final double window) {
		this.raw = raw;
		this.window = window;
		squares = new double[2][raw.size()];
		excess = new double[2][raw.size()];
		curvatureDifference = new double[raw.size()];
		shift = new double[3][raw.size()];
	}

	/** Differences at point {@code i}, and their variances for unit noise. */
	void compare(final int i, final double angle, final double angleVariance,
		final double curvature, final double curvatureVariance) {
		squares[ANGLE][i] = angle * angle;
		excess[ANGLE][i] = angleVariance;
		squares[CURVATURE][i] = curvature * curvature;
		excess[CURVATURE][i] = curvatureVariance;
		curvatureDifference[i] = curvature;
	}

	/** Takes over what was found at another point. */
	void copy(final int from, final int to) {
		for (final double[][] values : new double[][][]{squares, excess})
			for (final double[] row : values)
				row[to] = row[from];
		curvatureDifference[to] = curvatureDifference[from];
		for (final double[] row : shift)
			row[to] = row[from];
	}

	/** Differences of column, row and speed at point {@code i}. */
	void shift(final int i, final double x, final double y, final double speed) {
		shift[0][i] = x;
		shift[1][i] = y;
		shift[2][i] = speed;
	}

	/** @return columns, rows and speeds of the higher order less the lower */
	double[][] shift() {
		return shift;
	}

	/** @return curvature of the higher order less that of the lower */
	double curvatureDifference(final int i) {
		return curvatureDifference[i];
	}

	/** @return the standard errors with the bias added in squares */
	double[] added(final int what, final double[] errors, final double sigma, final double[] part,
		final NoiseGain gain) {
		final double[] sums = new double[errors.length + 1];
		for (int i = 0; i < errors.length; i++)
			sums[i + 1] = sums[i] + squares[what][i]
				- sigma * sigma * excess[what][i] * gain.ofComparison(what + 1, part[i]);
		final double[] out = new double[errors.length];
		for (int i = 0; i < out.length; i++) {
			final int[] w = raw.window(raw.s(i), window, 1);
			out[i] = Math.sqrt(
				errors[i] * errors[i] + Math.max(0, (sums[w[1]] - sums[w[0]]) / (w[1] - w[0])));
		}
		return out;
	}
}
