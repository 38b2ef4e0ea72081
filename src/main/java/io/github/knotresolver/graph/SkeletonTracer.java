
package io.github.knotresolver.graph;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.graph.GraphDraft.Vertex;
import io.github.knotresolver.graph.Node.Kind;

/**
 * Cuts a skeleton at its branch pixels. What remains are plain chains: a pixel
 * that is no branch pixel has at most two neighbours.
 */
final class SkeletonTracer {

	private final SkeletonPixels pixels;
	private final GraphDraft draft = new GraphDraft();
	private final Vertex[] junctionAt;
	private final boolean[] branches;
	private final boolean[] rest;

	private SkeletonTracer(final SkeletonPixels pixels) {
		this.pixels = pixels;
		branches = pixels.part(true);
		rest = pixels.part(false);
		junctionAt = new Vertex[branches.length];
	}

	/** The graph as it is, before any cleaning. Isolated pixels are dropped. */
	static GraphDraft trace(final SkeletonPixels pixels) {
		final SkeletonTracer tracer = new SkeletonTracer(pixels);
		pixels.components(tracer.branches).forEach(tracer::addJunction);
		pixels.components(tracer.rest).forEach(tracer::addRun);
		return tracer.draft;
	}

	private void addJunction(final List<Integer> cluster) {
		final List<Point> points = cluster.stream().map(this::point).toList();
		final double x = points.stream().mapToDouble(Point::x).average().orElseThrow();
		final double y = points.stream().mapToDouble(Point::y).average().orElseThrow();
		final Vertex junction = draft.add(Kind.JUNCTION, new Point(x, y), points);
		for (final int p : cluster)
			junctionAt[p] = junction;
	}

	private void addRun(final List<Integer> component) {
		final List<Integer> ends = component.stream()
			.filter(p -> pixels.neighbours(p, rest).size() < 2).toList();
		if (ends.isEmpty())
			addRing(component.get(0));
		else if (component.size() == 1)
			addSinglePixel(component.get(0));
		else {
			final List<Integer> order = walk(ends.get(0));
			final Vertex from = endOf(order.get(0)), to = endOf(order.get(order.size() - 1));
			draft.connect(from, to, between(from, order, to));
		}
	}

	private void addRing(final int first) {
		final Vertex vertex = draft.add(Kind.RING, point(first), List.of(point(first)));
		final List<Point> points = new ArrayList<>(walk(first).stream().map(this::point).toList());
		points.add(point(first));
		draft.connect(vertex, vertex, points);
	}

	private void addSinglePixel(final int pixel) {
		final List<Vertex> touched = touched(pixel);
		if (touched.isEmpty())
			return;
		if (touched.size() == 2)
			draft.connect(touched.get(0), touched.get(1),
				between(touched.get(0), List.of(pixel), touched.get(1)));
		else if (pixels.neighbours(pixel, branches).size() == 1) {
			final Vertex tip = freeEnd(pixel);
			draft.connect(tip, touched.get(0), between(tip, List.of(pixel), touched.get(0)));
		}
	}

	/** The junction that the end of a chain touches, or a new free end. */
	private Vertex endOf(final int pixel) {
		final List<Vertex> touched = touched(pixel);
		return touched.isEmpty() ? freeEnd(pixel) : touched.get(0);
	}

	private Vertex freeEnd(final int pixel) {
		return draft.add(Kind.FREE_END, point(pixel), List.of(point(pixel)));
	}

	private List<Vertex> touched(final int pixel) {
		return pixels.neighbours(pixel, branches).stream().map(p -> junctionAt[p]).distinct()
			.toList();
	}

	private List<Integer> walk(final int first) {
		final boolean[] open = Arrays.copyOf(rest, rest.length);
		final List<Integer> order = new ArrayList<>(List.of(first));
		open[first] = false;
		for (List<Integer> next = pixels.neighbours(first, open); !next.isEmpty(); next = pixels
			.neighbours(order.get(order.size() - 1), open)) {
			order.add(next.get(0));
			open[next.get(0)] = false;
		}
		return order;
	}

	private List<Point> between(final Vertex from, final List<Integer> order, final Vertex to) {
		final List<Point> points = new ArrayList<>();
		if (from.kind() == Kind.JUNCTION)
			points.add(from.position());
		order.forEach(p -> points.add(point(p)));
		if (to.kind() == Kind.JUNCTION)
			points.add(to.position());
		return points;
	}

	private Point point(final int pixel) {
		return new Point(pixels.x(pixel), pixels.y(pixel));
	}
}
