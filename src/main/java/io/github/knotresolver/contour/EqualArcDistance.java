
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

	/** The same for curves that are sampled at one pixel already. */
	static double mean(final double[] ax, final double[] ay, final double[] bx, final double[] by) {
		final int n = Math.min(ax.length, bx.length);
		double sum = 0;
		for (int i = 0; i < n; i++)
			sum += Math.hypot(ax[i] - bx[i], ay[i] - by[i]);
		return sum / n;
	}
}
