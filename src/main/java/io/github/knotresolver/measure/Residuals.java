
package io.github.knotresolver.measure;

/** Products of residuals that are some points apart, summed over contours. */
final class Residuals {

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
