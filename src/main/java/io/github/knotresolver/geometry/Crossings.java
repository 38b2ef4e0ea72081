package io.github.knotresolver.geometry;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;

/**
 * Where a curve crosses itself: two strands that meet and go on with their sides
 * exchanged. They may meet inside two links, at a vertex, or run along each other
 * for a while, forwards or backwards: that counts once. Strands that touch and
 * part on the sides they came from do not cross, nor does an end that lies on the
 * curve. Sides are decided exactly; see {@link Orientation}.
 * <p>
 * O(n²) in the number of links, with an early bounding-box test.
 */
public final class Crossings {

	/**
	 * @param place where the first strand is crossed: links from the start
	 * @param point the same in pixels
	 */
	record Crossing(double place, Point point) {
	}

	private Crossings() {
	}

	/**
	 * @param curve the curve
	 * @return the points where it crosses itself, in the order of the first strand's
	 *         arc length; of strands that run along each other, a point in the
	 *         middle
	 */
	public static List<Point> of(final Polyline curve) {
		final NodedCurve nodes = new NodedCurve(curve);
		final List<Crossing> found = new ArrayList<>(new SharedRuns(nodes).crossings());
		for (int i = 0; i < nodes.size() - 3; i++)
			for (int j = i + 2; j < nodes.size() - 1; j++)
				if (boxesMeet(nodes, i, j))
					addInside(nodes, i, j, found);
		return found.stream().sorted(Comparator.comparingDouble(Crossing::place))
			.map(Crossing::point).toList();
	}

	/**
	 * O(nm) in the numbers of links, with an early bounding-box test.
	 *
	 * @param a a curve
	 * @param b another
	 * @return whether a link of one crosses a link of the other, away from their ends
	 */
	public static boolean isBetween(final Polyline a, final Polyline b) {
		for (int i = 0; i < a.size() - 1; i++) {
			final Point p = a.point(i), q = a.point(i + 1);
			for (int j = 0; j < b.size() - 1; j++) {
				if (Math.max(b.x(j), b.x(j + 1)) < Math.min(p.x(), q.x())
					|| Math.min(b.x(j), b.x(j + 1)) > Math.max(p.x(), q.x()))
					continue;
				final Point r = b.point(j), s = b.point(j + 1);
				if (Orientation.of(p, q, r) * Orientation.of(p, q, s) < 0
					&& Orientation.of(r, s, p) * Orientation.of(r, s, q) < 0)
					return true;
			}
		}
		return false;
	}

	private static boolean boxesMeet(final NodedCurve v, final int i, final int j) {
		final Point a = v.node(i), b = v.node(i + 1), c = v.node(j), d = v.node(j + 1);
		return Math.max(c.x(), d.x()) >= Math.min(a.x(), b.x()) && //
			Math.min(c.x(), d.x()) <= Math.max(a.x(), b.x()) && //
			Math.max(c.y(), d.y()) >= Math.min(a.y(), b.y()) && //
			Math.min(c.y(), d.y()) <= Math.max(a.y(), b.y());
	}

	/** Two links that cross away from all nodes. */
	private static void addInside(final NodedCurve v, final int i, final int j,
		final List<Crossing> found) {
		final Point a = v.node(i), b = v.node(i + 1), c = v.node(j), d = v.node(j + 1);
		if (Orientation.of(a, b, c) * Orientation.of(a, b, d) >= 0
			|| Orientation.of(c, d, a) * Orientation.of(c, d, b) >= 0)
			return;
		final double f = Math.min(1, Math.max(0, share(a, b, c, d)));
		found.add(new Crossing(v.place(i) + f * (v.place(i + 1) - v.place(i)),
			new Point(a.x() + f * (b.x() - a.x()), a.y() + f * (b.y() - a.y()))));
	}

	/** Which part of the way from a to b the line through c and d is met. */
	private static double share(final Point a, final Point b, final Point c, final Point d) {
		final double dx = d.x() - c.x(), dy = d.y() - c.y();
		final double from = dx * (a.y() - c.y()) - dy * (a.x() - c.x()),
			to = dx * (b.y() - c.y()) - dy * (b.x() - c.x());
		return from == to ? 0.5 : from / (from - to);
	}
}
