
package io.github.knotresolver.graph;

import java.util.ArrayList;
import java.util.Collection;
import java.util.Collections;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;

import org.jgrapht.Graph;
import org.jgrapht.Graphs;
import org.jgrapht.graph.Pseudograph;

import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.graph.Node.Kind;

/** A graph that is still being cleaned: spurs go, junctions of two merge. */
final class GraphDraft {

	/** Reading order: by row, then by column. */
	static final Comparator<Point> SCAN_ORDER = Comparator.comparingDouble(Point::y)
		.thenComparingDouble(Point::x);

	/** A node that may still change its kind. Equal to itself only. */
	static final class Vertex {

		private final Point position;
		private final List<Point> pixels;
		private Kind kind;

		Vertex(final Kind kind, final Point position, final List<Point> pixels) {
			this.kind = kind;
			this.position = position;
			this.pixels = pixels;
		}

		Point position() {
			return position;
		}

		List<Point> pixels() {
			return pixels;
		}

		Kind kind() {
			return kind;
		}
	}

	/** A run of pixels from one vertex to another. Equal to itself only. */
	static final class PixelRun {

		private final List<Point> points;

		PixelRun(final List<Point> points) {
			this.points = points;
		}

		Polyline line() {
			return Polyline.of(points);
		}

		Point firstInScanOrder() {
			return Collections.min(points, SCAN_ORDER);
		}

		private List<Point> from(final Point start) {
			final List<Point> oriented = new ArrayList<>(points);
			if (!oriented.get(0).equals(start))
				Collections.reverse(oriented);
			return oriented;
		}
	}

	private final Graph<Vertex, PixelRun> graph = new Pseudograph<>(PixelRun.class);

	Graph<Vertex, PixelRun> graph() {
		return graph;
	}

	Vertex add(final Kind kind, final Point position, final List<Point> pixels) {
		final Vertex vertex = new Vertex(kind, position, pixels);
		graph.addVertex(vertex);
		return vertex;
	}

	void connect(final Vertex from, final Vertex to, final List<Point> points) {
		graph.addEdge(from, to, new PixelRun(points));
	}

	/**
	 * Removes notches, merges the two segments of junctions that have only two,
	 * and prunes spurs, the shortest first, so that of a forked tip the longer
	 * prong stays.
	 */
	void clean(final double spurLength, final Collection<Point> keep) {
		for (final PixelRun c : List.copyOf(graph.edgeSet()))
			if (graph.getEdgeSource(c) == graph.getEdgeTarget(c)
				&& graph.getEdgeSource(c).kind == Kind.JUNCTION
				&& c.line().length() < GraphTuning.NOTCH)
				graph.removeEdge(c);
		for (final Vertex v : List.copyOf(graph.vertexSet()))
			settle(v);
		for (Optional<PixelRun> spur = shortestSpur(spurLength, keep); spur
			.isPresent(); spur = shortestSpur(spurLength, keep))
			prune(spur.get());
	}

	private Optional<PixelRun> shortestSpur(final double spurLength, final Collection<Point> keep) {
		return graph.edgeSet().stream()
			.filter(c -> c.line().length() < spurLength && isSpur(c, keep))
			.min(Comparator.comparingDouble((PixelRun c) -> c.line().length())
				.thenComparing(PixelRun::firstInScanOrder, SCAN_ORDER));
	}

	private boolean isSpur(final PixelRun c, final Collection<Point> keep) {
		final Vertex a = graph.getEdgeSource(c), b = graph.getEdgeTarget(c);
		if ((a.kind == Kind.FREE_END) == (b.kind == Kind.FREE_END))
			return false;
		final Vertex tip = a.kind == Kind.FREE_END ? a : b;
		return keep.stream().noneMatch(k -> k.distanceTo(tip.position) < GraphTuning.KEPT);
	}

	private void prune(final PixelRun spur) {
		final Vertex a = graph.getEdgeSource(spur), b = graph.getEdgeTarget(spur);
		final Vertex tip = a.kind == Kind.FREE_END ? a : b;
		graph.removeVertex(tip);
		settle(tip == a ? b : a);
	}

	/** Gives a junction the kind that its number of segment ends asks for. */
	private void settle(final Vertex v) {
		if (v.kind != Kind.JUNCTION)
			return;
		switch (graph.degreeOf(v)) {
			case 0 -> graph.removeVertex(v);
			case 1 -> v.kind = Kind.FREE_END;
			case 2 -> merge(v);
			default -> {
				// A junction indeed.
			}
		}
	}

	private void merge(final Vertex v) {
		final List<PixelRun> arms = List.copyOf(graph.edgesOf(v));
		if (arms.size() == 1) {
			v.kind = Kind.RING;
			return;
		}
		final Vertex from = Graphs.getOppositeVertex(graph, arms.get(0), v);
		final Vertex to = Graphs.getOppositeVertex(graph, arms.get(1), v);
		final List<Point> points = arms.get(0).from(v.position);
		Collections.reverse(points);
		final List<Point> rest = arms.get(1).from(v.position);
		points.addAll(rest.subList(1, rest.size()));
		graph.removeVertex(v);
		connect(from, to, points);
	}
}
