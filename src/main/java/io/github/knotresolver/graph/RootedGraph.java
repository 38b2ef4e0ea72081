package io.github.knotresolver.graph;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;

import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.graph.Node.Kind;

/**
 * A skeleton graph and the nodes from which a walk may begin. Where no free end
 * is near the fixed end (it lies under another strand), the segment nearest to
 * it is divided there by an {@link Kind#ANCHOR} node.
 *
 * @param graph the graph
 * @param roots where a walk may begin, the nearest to the fixed end first;
 *          empty if and only if the graph has no segments
 */
public record RootedGraph(SkeletonGraph graph, List<Node> roots) {

	public RootedGraph {
		roots = List.copyOf(roots);
	}

	/**
	 * Finds where walks may begin. O(pixels of the graph).
	 *
	 * @param graph a skeleton graph
	 * @param fixedEnd the fixed end in pixels
	 * @return the graph, divided at the fixed end if need be, and its roots
	 */
	public static RootedGraph of(final SkeletonGraph graph, final Point fixedEnd) {
		final Comparator<Node> nearest = Comparator
			.comparingDouble(n -> n.position().distanceTo(fixedEnd));
		final Optional<Place> inside = nearestPlace(graph, fixedEnd);
		if (inside.isEmpty())
			return new RootedGraph(graph, List.of());
		final List<Node> near = graph.freeEnds().stream()
			.filter(n -> n.position().distanceTo(fixedEnd) <= GraphTuning.NEAR_CLAMP)
			.sorted(nearest).toList();
		if (!near.isEmpty() && near.get(0).position().distanceTo(fixedEnd) <= inside.get().distance
			+ GraphTuning.END_PREFERENCE)
			return new RootedGraph(graph, near);
		final Place place = inside.get();
		final Optional<Node> existing = graph.nodes().stream()
			.filter(n -> n.position().distanceTo(place.point()) <= GraphTuning.SAME_NODE)
			.min(nearest);
		return existing.isPresent()
			? rooted(graph, existing.get(), near)
			: divided(graph, place, near);
	}

	/**
	 * How much of the filament thinning has taken off at the fixed end: a skeleton ends
	 * about half a width before the filament does.
	 *
	 * @param fixedEnd the fixed end in pixels
	 * @return distance from the fixed end to the first root in pixels, at most 5; 0 if that
	 *         is no free end
	 */
	public double hidden(final Point fixedEnd) {
		return roots.isEmpty() || !roots.get(0).isFreeEnd()
			? 0
			: Math.min(GraphTuning.MOST_HIDDEN, roots.get(0).position().distanceTo(fixedEnd));
	}

	private static RootedGraph rooted(final SkeletonGraph graph, final Node first,
		final List<Node> others) {
		final List<Node> roots = new ArrayList<>(List.of(first));
		others.stream().filter(n -> n.id() != first.id()).forEach(roots::add);
		return new RootedGraph(graph, roots);
	}

	private static RootedGraph divided(final SkeletonGraph graph, final Place place,
		final List<Node> others) {
		final Node anchor = new Node(graph.nodes().size(), Kind.ANCHOR, place.point(),
			List.of(place.point()));
		final List<Node> nodes = new ArrayList<>(graph.nodes());
		nodes.add(anchor);
		final List<Segment> segments = new ArrayList<>(graph.segments());
		final Segment whole = place.segment;
		final Polyline chain = whole.chain();
		segments.set(whole.id(),
			new Segment(whole.id(), whole.source(), anchor, part(chain, 0, place.index)));
		segments.add(new Segment(segments.size(), anchor, whole.target(),
			part(chain, place.index, chain.size() - 1)));
		return rooted(new SkeletonGraph(nodes, segments), anchor, others);
	}

	private static Polyline part(final Polyline chain, final int from, final int to) {
		final List<Point> points = new ArrayList<>();
		for (int i = from; i <= to; i++)
			points.add(chain.point(i));
		return Polyline.of(points);
	}

	/** The nearest place on any segment; its nodes' positions count too. */
	private static Optional<Place> nearestPlace(final SkeletonGraph graph, final Point fixedEnd) {
		Place best = null;
		for (final Segment s : graph.segments())
			for (int i = 0; i < s.chain().size(); i++) {
				final double d = s.chain().point(i).distanceTo(fixedEnd);
				if (best == null || d < best.distance)
					best = new Place(s, i, d);
			}
		return Optional.ofNullable(best);
	}

	private record Place(Segment segment, int index, double distance) {

		Point point() {
			return segment.chain().point(index);
		}
	}
}
