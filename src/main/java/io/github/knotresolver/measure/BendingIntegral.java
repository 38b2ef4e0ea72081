
package io.github.knotresolver.measure;

/**
 * Half the integral of squared curvature, without what noise adds to it and
 * with what smoothing takes from it, and its standard error: noise to first
 * order through every point's influence, to second order for nearly straight
 * filaments, and the correction itself.
 */
final class BendingIntegral {

	/** Length over which errors of curvature are alike, in windows. */
	private static final double ALIKE = 0.6;

	private final Samples raw;
	private final double[] curvature;
	private final double[] variance;
	private final CurvatureWeights weights;
	private final SmoothingBias bias;

	BendingIntegral(final Samples raw, final double[] curvature, final double[] variance,
		final CurvatureWeights weights, final SmoothingBias bias) {
		this.raw = raw;
		this.curvature = curvature;
		this.variance = variance;
		this.weights = weights;
		this.bias = bias;
	}

	/** @param noise variance of a point, inflated for correlation */
	Estimate measured(final double noise, final double window) {
		final int n = raw.size();
		final double[] influence = new double[n];
		double energy = 0, second = 0, drift = 0;
		for (int i = 0; i < n; i++) {
			final double ds = step(i), k = curvature[i], v = noise * variance[i];
			energy += (k * k - v) * ds / 2;
			second += v * v * ds * ALIKE * window / 2;
			drift += k * bias.curvatureDifference(i) * ds;
			weights.add(i, k * ds, influence);
			influence[i] += k * k * k * ds / 2;
		}
		double first = 0;
		for (final double g : influence)
			first += g * g * noise;
		return new Estimate(energy + drift, Math.sqrt(first + second + 2 * drift * drift));
	}

	private double step(final int i) {
		return (raw.s(Math.min(i + 1, raw.size() - 1)) - raw.s(Math.max(i - 1, 0))) / 2;
	}
}
