
package io.github.knotresolver.measure;

/**
 * The smoothed curve and its derivatives at every point.
 */
final class SmoothedCurve {

	/** How often in a window the bias is looked at. */
	private static final int COMPARED = 8;
	/** Smallest part of the noise that a residual is taken to show. */
	private static final double LEAST_FREEDOM = 0.4;

	/**
	 * Angular frequency per window at which the filters for value, first and
	 * second derivative pass most noise.
	 */
	private static final double VALUE_TURN = 3, SLOPE_TURN = 6, BEND_TURN = 8;

	private final Samples raw;
	private final double windowPoints;
	private final double[] x;
	private final double[] y;
	private final double[] speed;
	private final double[] angle;
	private final double[] curvature;
	/** Variances of value, angle and curvature for unit noise. */
	private final double[][] variance;
	private final SmoothingBias bias;
	private final CurvatureWeights weights;

	private SmoothedCurve(final Samples raw, final double window, final int order) {
		final int n = raw.size();
		this.raw = raw;
		this.windowPoints = window / raw.spacing();
		x = new double[n];
		y = new double[n];
		speed = new double[n];
		angle = new double[n];
		curvature = new double[n];
		variance = new double[3][n];
		bias = new SmoothingBias(raw, window);
		weights = new CurvatureWeights(raw, order);
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
		final int stride = Math.max(1, (int) (windowPoints / COMPARED));
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
		return arcLength(0);
	}

	/**
	 * Integral of the speed, by the trapezoidal rule, less the detours that noise
	 * adds: half the variance of the tangent angle.
	 *
	 * @param noise variance of a point, inflated for correlation
	 */
	double[] arcLength(final double noise) {
		final double[] arc = new double[speed.length];
		for (int i = 1; i < arc.length; i++)
			arc[i] = arc[i - 1]
				+ (raw.s(i) - raw.s(i - 1)) * (straight(i, noise) + straight(i - 1, noise)) / 2;
		return arc;
	}

	private double straight(final int i, final double noise) {
		return speed[i] * (1 - Math.min(0.1, noise * variance[1][i] / 2));
	}

	Estimate bending(final CurveNoise noise, final double window) {
		final double inflated = noise.sigma() * noise.sigma() * noise.inflation();
		return new BendingIntegral(raw, curvature, variance[2], weights, bias).measured(inflated,
			window);
	}

	/** The noise, from the points' distances across the curve. */
	CurveNoise noise() {
		final int n = x.length;
		double square = 0, product = 0, leverage = 0, last = 0;
		for (int i = 0; i < n; i++) {
			final double across = (raw.y(i) - y[i]) * Math.cos(angle[i])
				- (raw.x(i) - x[i]) * Math.sin(angle[i]);
			square += across * across / n;
			product += across * last / (n - 1);
			leverage += variance[0][i] / n;
			last = across;
		}
		final double rho = correlation(square, product, leverage);
		final double inflation = (1 + rho) / (1 - rho);
		final double sigma = Math.sqrt(square
			/ Math.max(LEAST_FREEDOM, 1 - leverage * Math.pow(inflation(rho, SLOPE_TURN), 2)));
		final double scale = sigma * Math.sqrt(inflation);
		return new CurveNoise(sigma, inflation, roots(variance[0], scale),
			bias.added(SmoothingBias.ANGLE, roots(variance[1], scale), scale),
			bias.added(SmoothingBias.CURVATURE, roots(variance[2], scale), scale));
	}

	/**
	 * Root of the noise's spectrum, relative to independent errors, where the
	 * filter for a derivative listens.
	 */
	private double inflation(final double rho, final double turn) {
		return Math.sqrt((1 - rho * rho)
			/ (1 - 2 * rho * Math.cos(Math.min(Math.PI, turn / windowPoints)) + rho * rho));
	}

	/**
	 * Correlation ρ of neighbouring errors, 0 to 0.8. With mean leverage l and
	 * inflation g = (1 + ρ) / (1 - ρ), residuals have variance σ² (1 - l g) and
	 * covariance σ² (ρ - l g) with their neighbours; the two give a quadratic
	 * equation for 1 - ρ.
	 */
	private static double correlation(final double square, final double product,
		final double leverage) {
		if (square == 0)
			return 0;
		final double difference = square - product;
		final double b = difference * (1 + leverage);
		final double root = Math.sqrt(Math.max(0, b * b - 8 * square * leverage * difference));
		return Math.max(0, Math.min(0.8, 1 - (b + root) / (2 * square)));
	}

	private static double[] roots(final double[] variances, final double scale) {
		final double[] out = new double[variances.length];
		for (int i = 0; i < out.length; i++)
			out[i] = scale * Math.sqrt(variances[i]);
		return out;
	}
}
