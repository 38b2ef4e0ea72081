
package io.github.knotresolver.measure;

/**
 * The smoothed curve and its derivatives at every point.
 */
final class SmoothedCurve {

	private final Samples raw;
	private final double[] x;
	private final double[] y;
	private final double[] speed;
	private final double[] angle;
	private final double[] curvature;
	/** Variances of value, angle and curvature for unit noise. */
	private final double[][] variance;
	private final SmoothingBias bias;

	private SmoothedCurve(final Samples raw, final double window) {
		final int n = raw.size();
		this.raw = raw;
		x = new double[n];
		y = new double[n];
		speed = new double[n];
		angle = new double[n];
		curvature = new double[n];
		variance = new double[3][n];
		bias = new SmoothingBias(raw, window);
	}

	/** @return the curve smoothed with one window, at every point */
	static SmoothedCurve of(final Samples raw, final double window, final int order,
		final int leastPoints) {
		final SmoothedCurve curve = new SmoothedCurve(raw, window);
		final LocalPolynomial fit = new LocalPolynomial(order);
		for (int i = 0; i < raw.size(); i++) {
			final int[] w = raw.window(raw.s(i), window, leastPoints);
			fit.fit(raw, w[0], w[1], raw.s(i), window / 2, -1);
			curve.take(i, fit);
		}
		return curve;
	}

	/**
	 * Compares with the polynomial two orders higher, for the bias of smoothing.
	 */
	SmoothedCurve withBias(final double window, final int order, final int leastPoints) {
		final LocalPolynomial fit = new LocalPolynomial(order + 2);
		for (int i = 0; i < raw.size(); i++) {
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

	private void take(final int i, final LocalPolynomial fit) {
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
		final double[] arc = new double[speed.length];
		for (int i = 1; i < arc.length; i++)
			arc[i] = arc[i - 1] + (raw.s(i) - raw.s(i - 1)) * (speed[i] + speed[i - 1]) / 2;
		return arc;
	}

	/** The noise, from the points' distances across the curve. */
	CurveNoise noise() {
		final int n = x.length;
		final double[] across = new double[n];
		double squares = 0, freedom = 0, products = 0;
		for (int i = 0; i < n; i++) {
			across[i] = (raw.y(i) - y[i]) * Math.cos(angle[i])
				- (raw.x(i) - x[i]) * Math.sin(angle[i]);
			squares += across[i] * across[i];
			// For least squares a residual has variance 1 - leverage.
			freedom += 1 - variance[0][i];
			if (i > 0)
				products += across[i] * across[i - 1];
		}
		final double sigma = Math.sqrt(squares / Math.max(freedom, 1e-3 * n));
		final double rho = correlation(products, squares);
		final double inflation = (1 + rho) / (1 - rho);
		final double scale = sigma * Math.sqrt(inflation);
		return new CurveNoise(sigma, inflation, roots(variance[0], scale),
			bias.added(SmoothingBias.ANGLE, roots(variance[1], scale), scale),
			bias.added(SmoothingBias.CURVATURE, roots(variance[2], scale), scale));
	}

	/**
	 * Correlation of neighbouring errors, 0 to 0.8. Residuals of a fit are
	 * correlated by -leverage even if the errors are not; that much is added
	 * back.
	 */
	private double correlation(final double products, final double squares) {
		if (squares == 0)
			return 0;
		double leverage = 0;
		for (final double v : variance[0])
			leverage += v / variance[0].length;
		final double r = products / squares + leverage / Math.max(0.1, 1 - leverage);
		return Math.max(0, Math.min(0.8, r));
	}

	private static double[] roots(final double[] variances, final double scale) {
		final double[] out = new double[variances.length];
		for (int i = 0; i < out.length; i++)
			out[i] = scale * Math.sqrt(variances[i]);
		return out;
	}
}
