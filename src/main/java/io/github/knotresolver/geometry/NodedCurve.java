package io.github.knotresolver.geometry;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;

/**
 * A curve whose links are divided at all vertices that lie on them, so that no
 * vertex lies inside a link and strands that run along each other have the same
 * nodes. A node differs from the one before. O(n²).
 */
final class NodedCurve {

	private final List<Point> nodes = new ArrayList<>();
	private final List<Double> places = new ArrayList<>();

	NodedCurve(final Polyline curve) {
		final List<Point> vertices = new ArrayList<>();
		for (int i = 0; i < curve.size(); i++)
			vertices.add(new Point(withoutSign(curve.x(i)), withoutSign(curve.y(i))));
		for (int i = 0; i < vertices.size() - 1; i++) {
			add(vertices.get(i), i);
			divide(vertices, i);
		}
		add(vertices.get(vertices.size() - 1), vertices.size() - 1);
	}

	/** -0 and 0 are one place, but not equal in a record. */
	private static double withoutSign(final double value) {
		return value == 0 ? 0 : value;
	}

	private void add(final Point node, final double place) {
		if (nodes.isEmpty() || !nodes.get(nodes.size() - 1).equals(node)) {
			nodes.add(node);
			places.add(place);
		}
	}

	/** Adds the vertices inside a link, in their order along it. */
	private void divide(final List<Point> vertices, final int i) {
		final Point a = vertices.get(i), b = vertices.get(i + 1);
		vertices.stream().filter(p -> isInside(a, b, p)).distinct()
			.sorted(Comparator.comparingDouble(a::distanceTo))
			.forEach(p -> add(p, i + a.distanceTo(p) / a.distanceTo(b)));
	}

	private static boolean isInside(final Point a, final Point b, final Point p) {
		return p.x() >= Math.min(a.x(), b.x()) && p.x() <= Math.max(a.x(), b.x())
			&& p.y() >= Math.min(a.y(), b.y()) && p.y() <= Math.max(a.y(), b.y()) && !p.equals(a)
			&& !p.equals(b) && Orientation.of(a, b, p) == 0;
	}

	/** @return the number of nodes */
	int size() {
		return nodes.size();
	}

	/** @return node i, 0 to {@code size() - 1} */
	Point node(final int i) {
		return nodes.get(i);
	}

	/** @return where node i lies along the curve, in links of the curve */
	double place(final int i) {
		return places.get(i);
	}
}
