
package io.github.knotresolver.measure;

import java.util.EnumMap;
import java.util.Map;

/**
 * The quantities of one contour with their standard errors, propagated to first
 * order. Smoothing averages noise across the curve; noise along the curve
 * disappears in the arc length except at the two ends, where it is not averaged
 * at all and governs the error of all lengths.
 */
final class FrameQuantities {

	private final double[] x;
	private final double[] y;
	private final double[] s;
	private final double[] angle;
	private final double[] curvature;
	private final CurveNoise noise;
	private final int last;

	FrameQuantities(final ContourGeometry g) {
		x = g.x();
		y = g.y();
		s = g.arcLength();
		angle = g.tangentAngle();
		curvature = g.curvature();
		noise = g.noise();
		last = x.length - 1;
	}

	Map<Quantity, Estimate> measured() {
		final Map<Quantity, Estimate> q = new EnumMap<>(Quantity.class);
		q.put(Quantity.LENGTH, length());
		q.put(Quantity.END_TO_END, endToEnd());
		q.put(Quantity.RADIUS_OF_GYRATION, radiusOfGyration());
		final double[] e = noise.tangentAngle();
		q.put(Quantity.TIP_ANGLE, new Estimate(angle[last], e[last]));
		q.put(Quantity.TURNING_NUMBER, new Estimate((angle[last] - angle[0]) / (2 * Math.PI),
			Math.hypot(e[0], e[last]) / (2 * Math.PI)));
		return q;
	}

	/** δL = [t·δr] at the ends - ∫ κ n·δr ds. */
	private Estimate length() {
		double across = 0;
		for (int i = 0; i <= last; i++)
			across += Math.pow(curvature[i] * step(i), 2);
		return new Estimate(s[last], noise.sigma() * Math.sqrt(2 + noise.inflation() * across));
	}

	private Estimate endToEnd() {
		final double dx = x[last] - x[0], dy = y[last] - y[0];
		final double d = Math.hypot(dx, dy);
		final double towards = d > 0 ? Math.atan2(dy, dx) : angle[0];
		return new Estimate(d, Math.hypot(endError(0, towards), endError(last, towards)));
	}

	/** Standard error of an end point in one direction. */
	private double endError(final int i, final double direction) {
		final double turn = direction - angle[i];
		return Math.hypot(noise.sigma() * Math.cos(turn), noise.across()[i] * Math.sin(turn));
	}

	private Estimate radiusOfGyration() {
		final double length = s[last];
		double mx = 0, my = 0;
		for (int i = 0; i <= last; i++) {
			mx += x[i] * step(i) / length;
			my += y[i] * step(i) / length;
		}
		double square = 0, across = 0;
		for (int i = 0; i <= last; i++) {
			final double cx = x[i] - mx, cy = y[i] - my;
			square += (cx * cx + cy * cy) * step(i) / length;
			final double normal = cy * Math.cos(angle[i]) - cx * Math.sin(angle[i]);
			across += Math.pow(normal * step(i) / length, 2);
		}
		final double radius = Math.sqrt(square);
		final double ends = Math.hypot(reach(0, mx, my) - square, reach(last, mx, my) - square)
			/ (2 * length);
		return new Estimate(radius,
			noise.sigma() * Math.sqrt(noise.inflation() * across + ends * ends) / radius);
	}

	private double reach(final int i, final double mx, final double my) {
		return (x[i] - mx) * (x[i] - mx) + (y[i] - my) * (y[i] - my);
	}

	private double step(final int i) {
		return (s[Math.min(i + 1, last)] - s[Math.max(i - 1, 0)]) / 2;
	}
}
