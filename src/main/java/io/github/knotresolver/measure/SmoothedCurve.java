
package io.github.knotresolver.measure;

import io.github.knotresolver.geometry.Angles;

/**
 * The smoothed curve and its derivatives at every point.
 */
final class SmoothedCurve {

	private final Samples raw;
	private final double windowPoints;
	private final double[] x;
	private final double[] y;
	private final double[] speed;
	private final double[] angle;
	private final double[] curvature;
	/** Place in the window, from its middle (0) to its end (1). */
	private final double[] part;
	/** Variances of value, angle and curvature for unit independent noise. */
	private final double[][] variance;
	private final SmoothingBias bias;
	private final BendingIntegral.Weights weights;

	private SmoothedCurve(final Samples raw, final double window, final int order) {
		final int n = raw.size();
		this.raw = raw;
		this.windowPoints = window / raw.spacing();
		x = new double[n];
		y = new double[n];
		speed = new double[n];
		angle = new double[n];
		curvature = new double[n];
		part = new double[n];
		variance = new double[3][n];
		bias = new SmoothingBias(raw, window);
		weights = new BendingIntegral.Weights(raw, order);
	}

	/** @return the curve smoothed with one window, at every point */
	static SmoothedCurve of(final Samples raw, final double window, final int order,
		final int leastPoints) {
		final SmoothedCurve curve = new SmoothedCurve(raw, window, order);
		final LocalPolynomial fit = new LocalPolynomial(order);
		for (int i = 0; i < raw.size(); i++) {
			final int[] w = raw.window(raw.s(i), window, leastPoints);
			fit.fit(raw, w[0], w[1], raw.s(i), window / 2, -1);
			curve.take(i, w, fit);
		}
		return curve;
	}

	/**
	 * Compares with the polynomial two orders higher, for the bias of smoothing.
	 */
	SmoothedCurve withBias(final double window, final int order, final int leastPoints) {
		final LocalPolynomial fit = new LocalPolynomial(order + 2);
		final int stride = Math.max(1, (int) (windowPoints / MeasureTuning.COMPARED));
		for (int i = 0; i < raw.size(); i++) {
			if (i % stride != 0) {
				bias.copy(i - 1, i);
				continue;
			}
			final int[] w = raw.window(raw.s(i), window, leastPoints);
			if (w[1] - w[0] < order + 4)
				continue;
			fit.fit(raw, w[0], w[1], raw.s(i), window / 2, -1);
			final double dx = fit.x(1), dy = fit.y(1), v2 = dx * dx + dy * dy;
			bias.shift(i, fit.x(0) - x[i], fit.y(0) - y[i], Math.sqrt(v2) - speed[i]);
			bias.compare(i, Angles.nearest(Math.atan2(dy, dx), angle[i]) - angle[i],
				fit.variance(1) / v2 - variance[1][i], //
				(dx * fit.y(2) - dy * fit.x(2)) / (v2 * Math.sqrt(v2)) - curvature[i],
				fit.variance(2) / (v2 * v2) - variance[2][i]);
		}
		return this;
	}

	private void take(final int i, final int[] window, final LocalPolynomial fit) {
		final double dx = fit.x(1), dy = fit.y(1);
		final double v2 = dx * dx + dy * dy;
		final double from = raw.s(window[0]), to = raw.s(window[1] - 1);
		part[i] = to > from ? Math.abs(2 * raw.s(i) - from - to) / (to - from) : 0;
		x[i] = fit.x(0);
		y[i] = fit.y(0);
		speed[i] = Math.sqrt(v2);
		final double wrapped = Math.atan2(dy, dx);
		angle[i] = i == 0 ? wrapped : Angles.nearest(wrapped, angle[i - 1]);
		curvature[i] = (dx * fit.y(2) - dy * fit.x(2)) / (v2 * speed[i]);
		variance[0][i] = fit.variance(0);
		variance[1][i] = fit.variance(1) / v2;
		variance[2][i] = fit.variance(2) / (v2 * v2);
		weights.keep(i, window, fit, 1 / v2);
	}

	double[] x() {
		return x;
	}

	double[] y() {
		return y;
	}

	double[] tangentAngle() {
		return angle;
	}

	double[] curvature() {
		return curvature;
	}

	/** Integral of the speed, by the trapezoidal rule. */
	double[] arcLength() {
		return integral(new double[speed.length]);
	}

	/**
	 * Integral of the speed, by the trapezoidal rule, less the detours that noise
	 * adds: half the variance of the tangent angle.
	 */
	double[] arcLength(final double sigma, final NoiseGain gain) {
		return integral(variances(1, sigma, gain));
	}

	private double[] integral(final double[] detours) {
		final double[] arc = new double[speed.length];
		for (int i = 1; i < arc.length; i++)
			arc[i] = arc[i - 1]
				+ (raw.s(i) - raw.s(i - 1)) * (straight(i, detours) + straight(i - 1, detours)) / 2;
		return arc;
	}

	private double straight(final int i, final double[] detours) {
		return speed[i] * (1 - Math.min(0.1, detours[i] / 2));
	}

	Estimate bending(final ContourGeometry.CurveNoise noise, final NoiseGain gain,
		final double window) {
		final double[] crossed = new double[x.length];
		for (int i = 0; i < crossed.length; i++)
			crossed[i] = noise.sigma() * noise.sigma() * variance[2][i] * gain.ofProduct(part[i]);
		return new BendingIntegral(raw, curvature, variances(2, noise.sigma(), gain), crossed,
			weights, bias).measured(noise.sigma() * noise.sigma(), noise.inflation(), window);
	}

	/** Columns, rows and speeds of the polynomial two orders higher, less these. */
	double[][] shift() {
		return bias.shift();
	}

	/** How many points a full window has. */
	double windowPoints() {
		return windowPoints;
	}

	/** Adds the residuals of the points away from the ends. */
	void addResiduals(final ErrorCorrelation.Residuals pooled) {
		int from = 0, to = x.length;
		while (from < to && part[from] > MeasureTuning.MIDDLE)
			from++;
		while (to > from && part[to - 1] > MeasureTuning.MIDDLE)
			to--;
		pooled.add(across(), from, to);
	}

	/** Distances of the points across the curve. */
	private double[] across() {
		final double[] across = new double[x.length];
		for (int i = 0; i < across.length; i++)
			across[i] = (raw.y(i) - y[i]) * Math.cos(angle[i])
				- (raw.x(i) - x[i]) * Math.sin(angle[i]);
		return across;
	}

	/** Size of the errors, from the points' distances across the curve. */
	double sigma(final NoiseGain gain) {
		double square = 0, freedom = 0;
		for (final double a : across())
			square += a * a;
		for (final double p : part)
			freedom += gain.freedom(p);
		return Math.sqrt(square / freedom);
	}

	/** What errors of a size do to this curve. */
	ContourGeometry.CurveNoise noise(final double sigma, final boolean held, final NoiseGain gain) {
		return new ContourGeometry.CurveNoise(sigma, gain.along(), held, errors(0, sigma, gain),
			bias.added(SmoothingBias.ANGLE, errors(1, sigma, gain), sigma, part, gain),
			bias.added(SmoothingBias.CURVATURE, errors(2, sigma, gain), sigma, part, gain));
	}

	private double[] errors(final int derivative, final double sigma, final NoiseGain gain) {
		final double[] out = variances(derivative, sigma, gain);
		for (int i = 0; i < out.length; i++)
			out[i] = Math.sqrt(out[i]);
		return out;
	}

	private double[] variances(final int derivative, final double sigma, final NoiseGain gain) {
		final double[] out = new double[x.length];
		for (int i = 0; i < out.length; i++)
			out[i] = sigma * sigma * variance[derivative][i] * gain.ofFit(derivative, part[i]);
		return out;
	}
}
