package io.github.knotresolver.imagej.accuracy;

import java.util.EnumMap;
import java.util.Map;

import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.measure.Quantity;

/** Quantities of an exact curve, by finite differences and without smoothing. */
final class Exact {

	/** Steps of the differences, in pixels: more than a simulated link. */
	private static final double STEP = 1;

	private Exact() {
	}

	static Map<Quantity, Double> of(final Polyline truth, final double pixelSize) {
		final Polyline p = truth.divided((int) Math.rint(truth.length() / STEP));
		final int n = p.size() - 1;
		double first = 0, last = 0, bend = 0;
		for (int i = 0; i < n; i++) {
			final double wrapped = Math.atan2(p.y(i + 1) - p.y(i), p.x(i + 1) - p.x(i));
			final double turn = i == 0 ? 0 : Math.IEEEremainder(wrapped - last, 2 * Math.PI);
			bend += turn * turn;
			last = i == 0 ? wrapped : last + turn;
			if (i == 0)
				first = wrapped;
		}
		final Map<Quantity, Double> exact = new EnumMap<>(Quantity.class);
		exact.put(Quantity.LENGTH, truth.length() * pixelSize);
		exact.put(Quantity.END_TO_END, truth.first().distanceTo(truth.last()) * pixelSize);
		exact.put(Quantity.TIP_ANGLE, last);
		exact.put(Quantity.TURNING_NUMBER, (last - first) / (2 * Math.PI));
		exact.put(Quantity.RADIUS_OF_GYRATION, radius(p) * pixelSize);
		exact.put(Quantity.BENDING_ENERGY, bend / 2 * n / (truth.length() * pixelSize));
		return exact;
	}

	private static double radius(final Polyline p) {
		double mx = 0, my = 0, square = 0, weights = 0;
		for (int i = 0; i < p.size(); i++) {
			final double w = i == 0 || i == p.size() - 1 ? 0.5 : 1;
			weights += w;
			mx += w * p.x(i);
			my += w * p.y(i);
			square += w * (p.x(i) * p.x(i) + p.y(i) * p.y(i));
		}
		mx /= weights;
		my /= weights;
		return Math.sqrt(square / weights - mx * mx - my * my);
	}
}
