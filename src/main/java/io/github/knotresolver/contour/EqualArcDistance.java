
package io.github.knotresolver.contour;

import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.geometry.Polyline;

/**
 * How far material points have moved: a filament does not stretch, so the point
 * at an arc length from the fixed end is the same piece of filament in every
 * frame.
 */
public final class EqualArcDistance {

	private EqualArcDistance() {
	}

	/**
	 * Mean distance of the points at equal arc length from the first points, over
	 * the length of the shorter curve, sampled at (nearly) one pixel. O(n).
	 *
	 * @implNote op names="knotresolver.equalArcDistance"
	 * @param a a curve
	 * @param b another
	 * @return the mean distance in pixels
	 */
	public static double mean(final Polyline a, final Polyline b) {
		final double shorter = Math.min(a.length(), b.length());
		final int steps = Math.max(1, (int) Math.rint(shorter));
		double sum = 0;
		for (int i = 0; i <= steps; i++) {
			final Point p = a.at(shorter * i / steps), q = b.at(shorter * i / steps);
			sum += p.distanceTo(q);
		}
		return sum / (steps + 1);
	}

	/**
	 * The same for two curves that are sampled at the same spacing already
	 * ({@link Polyline#every}).
	 *
	 * @param a a curve
	 * @param b another, of the same spacing
	 * @return the mean distance of points of equal index, in pixels
	 */
	public static double meanOfSampled(final Polyline a, final Polyline b) {
		final int n = Math.min(a.size(), b.size());
		double sum = 0;
		for (int i = 0; i < n; i++)
			sum += Math.hypot(a.x(i) - b.x(i), a.y(i) - b.y(i));
		return sum / n;
	}
}
