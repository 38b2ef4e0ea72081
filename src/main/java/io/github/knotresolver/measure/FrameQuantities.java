
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
	private final ContourGeometry.CurveNoise noise;
	private final double[][] shift;
	private final double lengthError;
	private final int last;

	/**
	 * @param lengthError standard error that all frames' lengths have in common, in
	 *          the unit of length
	 */
	FrameQuantities(final ContourGeometry g, final double lengthError) {
		x = g.x();
		y = g.y();
		s = g.arcLength();
		angle = g.tangentAngle();
		curvature = g.curvature();
		noise = g.noise();
		shift = g.shift();
		this.lengthError = lengthError;
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
		double across = 0, stretch = 0;
		for (int i = 0; i <= last; i++) {
			across += Math.pow(curvature[i] * step(i), 2);
			stretch += shift[2][i] * step(i);
		}
		final double bends = noise.held() ? 0 : noise.inflation() * across;
		return new Estimate(s[last],
			Math.hypot(noise.sigma() * Math.sqrt(2 + bends), Math.hypot(lengthError, stretch)));
	}

	/** The tip slides along the curve with the length. */
	private Estimate endToEnd() {
		final double dx = x[last] - x[0], dy = y[last] - y[0];
		final double d = Math.hypot(dx, dy);
		final double towards = d > 0 ? Math.atan2(dy, dx) : angle[0];
		return new Estimate(d, Math.hypot(endError(0, towards),
			Math.hypot(endError(last, towards), lengthError * Math.cos(towards - angle[last]))));
	}

	/** Standard error of an end point in one direction. */
	private double endError(final int i, final double direction) {
		final double turn = direction - angle[i];
		return Math.hypot(noise.sigma() * Math.cos(turn), noise.across()[i] * Math.sin(turn));
	}

	private Estimate radiusOfGyration() {
		final double length = s[last];
		final double[] weight = new double[last + 1];
		for (int i = 0; i <= last; i++)
			weight[i] = step(i) / length;
		final double mx = mean(x, weight), my = mean(y, weight);
		double square = 0, across = 0;
		for (int i = 0; i <= last; i++) {
			final double cx = x[i] - mx, cy = y[i] - my;
			square += (cx * cx + cy * cy) * weight[i];
			final double normal = cy * Math.cos(angle[i]) - cx * Math.sin(angle[i]);
			across += Math.pow(normal * weight[i], 2);
		}
		final double radius = Math.sqrt(square);
		final double base = (reach(0, mx, my) - square) / (2 * length),
			tip = (reach(last, mx, my) - square) / (2 * length);
		final double random = noise.sigma()
			* Math.sqrt(noise.inflation() * across + base * base + tip * tip);
		return new Estimate(radius, Math.hypot(Math.hypot(random, lengthError * tip) / radius,
			unsmoothedRadius(weight) - radius));
	}

	/** The radius of gyration of the polynomial two orders higher. */
	private double unsmoothedRadius(final double[] weight) {
		final double[] ux = new double[last + 1], uy = new double[last + 1],
			w = new double[last + 1];
		double total = 0;
		for (int i = 0; i <= last; i++) {
			ux[i] = x[i] + shift[0][i];
			uy[i] = y[i] + shift[1][i];
			w[i] = weight[i] * (1 + shift[2][i]);
			total += w[i];
		}
		final double mx = mean(ux, w) / total, my = mean(uy, w) / total;
		double square = 0;
		for (int i = 0; i <= last; i++)
			square += ((ux[i] - mx) * (ux[i] - mx) + (uy[i] - my) * (uy[i] - my)) * w[i] / total;
		return Math.sqrt(square);
	}

	private static double mean(final double[] values, final double[] weight) {
		double sum = 0;
		for (int i = 0; i < values.length; i++)
			sum += values[i] * weight[i];
		return sum;
	}

	private double reach(final int i, final double mx, final double my) {
		return (x[i] - mx) * (x[i] - mx) + (y[i] - my) * (y[i] - my);
	}

	private double step(final int i) {
		return (s[Math.min(i + 1, last)] - s[Math.max(i - 1, 0)]) / 2;
	}
}
