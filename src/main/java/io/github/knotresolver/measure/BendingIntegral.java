
package io.github.knotresolver.measure;

/**
 * Half the integral of squared curvature, without what noise adds to it and
 * with what smoothing takes from it, and its standard error: noise to first
 * order through every point's influence, to second order for nearly straight
 * filaments, and half the correction. In the last half window at each end,
 * where curvature is not measured well, that of the innermost full window is
 * taken.
 */
final class BendingIntegral {

	private final Samples raw;
	private final double[] curvature;
	private final double[] variance;
	private final double[] crossed;
	private final Weights weights;
	private final SmoothingBias bias;

	BendingIntegral(final Samples raw, final double[] curvature, final double[] variance,
		final double[] crossed, final Weights weights, final SmoothingBias bias) {
		this.raw = raw;
		this.curvature = curvature;
		this.variance = variance;
		this.crossed = crossed;
		this.weights = weights;
		this.bias = bias;
	}

	/**
	 * @param square variance of a point
	 * @param correlated how many points share one point's error
	 * @param window width of the smoothing
	 */
	Estimate measured(final double square, final double correlated, final double window) {
		final double noise = square * correlated;
		final int n = raw.size();
		final int first = nearest(window / 2), last = nearest(raw.length() - window / 2);
		final double[] influence = new double[n];
		double energy = 0, straight = 0, smoothed = 0, seen = 0, taken = 0;
		for (int i = 0; i < n; i++) {
			final int c = Math.max(first, Math.min(last, i));
			final double ds = step(i), k = curvature[c], v = variance[c];
			energy += (k * k - v) * ds / 2;
			seen += k * k * ds / 2;
			taken += (v / 2 + crossed[c]) * ds;
			straight += v * v * ds * MeasureTuning.CURVATURE_CORRELATED * window / 2;
			smoothed += (k * bias.curvatureDifference(c) - crossed[c]) * ds;
			weights.add(c, k * ds, influence);
			influence[i] += k * k * k * ds / 2;
		}
		double bent = 0;
		for (final double g : influence)
			bent += g * g * noise;
		// The curvature that is seen is part noise, which has no influence.
		bent *= seen > 0 ? Math.max(0, energy / seen) : 0;
		final double ends = Math.hypot(endError(first, nearest(window), window),
			endError(last, nearest(raw.length() - window), window));
		// The noise that is taken off is itself known from few independent errors.
		final double guessed = taken * taken * 2 * correlated / n;
		return new Estimate(energy + smoothed,
			Math.sqrt(bent + straight + smoothed * smoothed / 4 + ends * ends + guessed));
	}

	/** What a change of curvature inside the last half window would make. */
	private double endError(final int i, final int inside, final double window) {
		final double change = Math.abs(curvature[i] - curvature[inside]);
		return (Math.abs(curvature[i]) + change / 2) * change / 2 * window / Math.sqrt(12);
	}

	private int nearest(final double s) {
		final int[] w = raw.window(s, 0, 1);
		return Math.min(raw.size() - 1, w[0]);
	}

	private double step(final int i) {
		return (raw.s(Math.min(i + 1, raw.size() - 1)) - raw.s(Math.max(i - 1, 0))) / 2;
	}

	/**
	 * How each point moves each curvature: the weights of the local polynomials.
	 */
	static final class Weights {

		private final Samples raw;
		private final int[] from;
		private final int[] to;
		/** Weight of point j for curvature i is a polynomial in s_j - s_i. */
		private final double[][] polynomial;

		Weights(final Samples raw, final int order) {
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
}
