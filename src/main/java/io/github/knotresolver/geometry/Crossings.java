
package io.github.knotresolver.geometry;

import java.util.ArrayList;
import java.util.List;

/**
 * Where a curve crosses itself: proper intersections of links that are not
 * neighbours. Touching without crossing does not count. O(n²) in the number of
 * links, with an early bounding-box test.
 */
public final class Crossings {

	private Crossings() {
	}

	/**
	 * @param curve the curve
	 * @return the points of proper self-intersection, in the order of the first
	 *         strand's arc length
	 */
	public static List<Point> of(final Polyline curve) {
		final List<Point> found = new ArrayList<>();
		final int links = curve.size() - 1;
		for (int i = 0; i < links - 2; i++)
			for (int j = i + 2; j < links; j++)
				if (boxesMeet(curve, i, j))
					addIntersection(curve, i, j, found);
		return found;
	}

	private static boolean boxesMeet(final Polyline c, final int i, final int j) {
		return Math.max(c.x(j), c.x(j + 1)) >= Math.min(c.x(i), c.x(i + 1)) && //
			Math.min(c.x(j), c.x(j + 1)) <= Math.max(c.x(i), c.x(i + 1)) && //
			Math.max(c.y(j), c.y(j + 1)) >= Math.min(c.y(i), c.y(i + 1)) && //
			Math.min(c.y(j), c.y(j + 1)) <= Math.max(c.y(i), c.y(i + 1));
	}

	private static void addIntersection(final Polyline c, final int i, final int j,
		final List<Point> found) {
		final double d1 = side(c, i, c.x(j), c.y(j)), d2 = side(c, i, c.x(j + 1), c.y(j + 1));
		final double d3 = side(c, j, c.x(i), c.y(i)), d4 = side(c, j, c.x(i + 1), c.y(i + 1));
		if (d1 * d2 >= 0 || d3 * d4 >= 0)
			return;
		final double f = d3 / (d3 - d4);
		found
			.add(new Point(c.x(i) + f * (c.x(i + 1) - c.x(i)), c.y(i) + f * (c.y(i + 1) - c.y(i))));
	}

	/** Twice the signed area of link {@code i} and a point. */
	private static double side(final Polyline c, final int i, final double px, final double py) {
		return (c.x(i + 1) - c.x(i)) * (py - c.y(i)) - (c.y(i + 1) - c.y(i)) * (px - c.x(i));
	}
}
