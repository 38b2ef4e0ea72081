
package io.github.knotresolver.measure;

/**
 * How each point moves each curvature: the weights of the local polynomials.
 */
final class CurvatureWeights {

	private final Samples raw;
	private final int[] from;
	private final int[] to;
	/** Weight of point j for curvature i is a polynomial in s_j - s_i. */
	private final double[][] polynomial;

	CurvatureWeights(final Samples raw, final int order) {
		this.raw = raw;
		from = new int[raw.size()];
		to = new int[raw.size()];
		polynomial = new double[raw.size()][order + 1];
	}

	void keep(final int i, final int[] window, final LocalPolynomial fit, final double scale) {
		from[i] = window[0];
		to[i] = window[1];
		fit.copyWeights(2, scale, polynomial[i]);
	}

	/** Adds {@code factor} times the weights for curvature {@code i}. */
	void add(final int i, final double factor, final double[] sum) {
		final double[] p = polynomial[i];
		for (int j = from[i]; j < to[i]; j++) {
			final double d = raw.s(j) - raw.s(i);
			double w = 0;
			for (int k = p.length - 1; k >= 0; k--)
				w = w * d + p[k];
			sum[j] += factor * w;
		}
	}
}
