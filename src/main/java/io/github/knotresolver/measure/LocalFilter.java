
package io.github.knotresolver.measure;

/**
 * The smoothing as a linear filter of equally spaced points: the weights of a
 * window's points for the value or a derivative at one of them.
 */
final class LocalFilter {

	private final int order;
	private final int points;
	private final Samples grid;

	/**
	 * @param order degree of the polynomial
	 * @param points of a full window; made odd, and more than the order
	 */
	LocalFilter(final int order, final int points) {
		this.order = order;
		this.points = Math.max(points, order + 2) | 1;
		this.grid = Samples.overIndex(new double[this.points]);
	}

	int points() {
		return points;
	}

	/** Index of the point that is {@code part} of the way from middle to end. */
	int index(final double part) {
		return points / 2 + (int) Math.rint(part * (points / 2));
	}

	/** Weights for derivative {@code d} at a point of the window. */
	double[] weights(final int d, final int at) {
		final LocalPolynomial fit = new LocalPolynomial(order);
		fit.fit(grid, 0, points, at, points / 2.0, -1);
		final double[] polynomial = new double[order + 1];
		fit.copyWeights(d, 1, polynomial);
		final double[] w = new double[points];
		for (int j = 0; j < points; j++)
			for (int k = order; k >= 0; k--)
				w[j] = w[j] * (j - at) + polynomial[k];
		return w;
	}

	/** What a point's residual takes of every point. */
	double[] residual(final int at) {
		final double[] w = weights(0, at);
		for (int j = 0; j < points; j++)
			w[j] = (j == at ? 1 : 0) - w[j];
		return w;
	}

	/**
	 * The response of residuals away from the ends, correlated with itself, from
	 * lag {@code 1 - points} to {@code points - 1}.
	 */
	double[] residualResponse() {
		final double[] h = residual(points / 2), out = new double[2 * points - 1];
		for (int i = 0; i < points; i++)
			for (int j = 0; j < points; j++)
				out[i - j + points - 1] += h[i] * h[j];
		return out;
	}
}
