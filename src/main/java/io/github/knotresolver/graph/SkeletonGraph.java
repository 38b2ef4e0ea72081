
package io.github.knotresolver.graph;

import java.util.ArrayList;
import java.util.Collection;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

import net.imglib2.RandomAccessibleInterval;
import net.imglib2.type.logic.BitType;

import org.jgrapht.Graph;
import org.jgrapht.graph.AsUnmodifiableGraph;
import org.jgrapht.graph.Pseudograph;

import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.graph.GraphDraft.PixelRun;
import io.github.knotresolver.graph.GraphDraft.Vertex;

/**
 * The graph of a skeleton: an undirected pseudograph whose vertices are
 * junctions (branch pixels, those whose 3x3 sum is at least 4, merged by
 * 8-connectivity) and free ends, and whose edges are the pixel chains between
 * them. Parallel edges and loops are normal. A closed ring without a junction
 * is one node with a loop; isolated pixels are left out; a junction of only two
 * segments (a kink of the staircase) is merged away.
 * <p>
 * Short spurs are pruned: they are thinning noise, and each would double the
 * number of trails. A true tip that stands out from another strand leaves a
 * spur as well, so only the very short ones go, and trails pay for the others
 * by the pixel if they leave them out. Immutable. Nodes and segments are
 * numbered in scan order.
 */
public final class SkeletonGraph {

	/** Spurs shorter than this (pixels) are pruned unless told otherwise. */
	public static final double DEFAULT_SPUR_LENGTH = 4;

	private final List<Node> nodes;
	private final List<Segment> segments;
	private final List<List<Step>> stepsFrom = new ArrayList<>();
	private final Graph<Node, Segment> graph = new Pseudograph<>(Segment.class);

	SkeletonGraph(final List<Node> nodes, final List<Segment> segments) {
		this.nodes = List.copyOf(nodes);
		this.segments = List.copyOf(segments);
		for (final Node n : this.nodes) {
			graph.addVertex(n);
			stepsFrom.add(new ArrayList<>());
		}
		for (final Segment s : this.segments) {
			graph.addEdge(s.source(), s.target(), s);
			stepsFrom.get(s.source().id()).add(new Step(s, true));
			stepsFrom.get(s.target().id()).add(new Step(s, false));
		}
	}

	/**
	 * The graph of a skeleton, with the default spur length and no point to keep.
	 *
	 * @param skeleton two-dimensional, one pixel wide, 8-connected; one or more
	 *          components
	 * @return its graph; without nodes if the skeleton is empty
	 */
	public static SkeletonGraph of(final RandomAccessibleInterval<BitType> skeleton) {
		return of(skeleton, DEFAULT_SPUR_LENGTH, List.of());
	}

	/**
	 * The graph of a skeleton. O(pixels + segments²).
	 *
	 * @param skeleton two-dimensional, one pixel wide, 8-connected; one or more
	 *          components
	 * @param spurLength segments with one free end that are shorter than this
	 *          (pixels, at least 0) are pruned
	 * @param keep points in pixels; a spur that ends within 4 px of one is kept:
	 *          pass the fixed end
	 * @return its graph; without nodes if the skeleton is empty
	 */
	public static SkeletonGraph of(final RandomAccessibleInterval<BitType> skeleton,
		final double spurLength, final Collection<Point> keep) {
		if (!(spurLength >= 0))
			throw new IllegalArgumentException(
				"The spur length must be at least 0 pixels, but is " + spurLength + ".");
		final GraphDraft draft = SkeletonTracer.trace(new SkeletonPixels(skeleton));
		draft.clean(spurLength, keep);
		return numbered(draft.graph());
	}

	private static SkeletonGraph numbered(final Graph<Vertex, PixelRun> draft) {
		final List<Node> nodes = new ArrayList<>();
		final Map<Vertex, Node> nodeOf = new HashMap<>();
		draft.vertexSet().stream()
			.sorted(Comparator.comparing(v -> v.pixels().get(0), GraphDraft.SCAN_ORDER))
			.forEach(v -> {
				final Node node = new Node(nodes.size(), v.kind(), v.position(), v.pixels());
				nodes.add(node);
				nodeOf.put(v, node);
			});
		final List<Segment> segments = new ArrayList<>();
		draft.edgeSet().stream()
			.sorted(Comparator.comparing(PixelRun::firstInScanOrder, GraphDraft.SCAN_ORDER))
			.forEach(c -> segments.add(segment(segments.size(), nodeOf.get(draft.getEdgeSource(c)),
				nodeOf.get(draft.getEdgeTarget(c)), c.line())));
		return new SkeletonGraph(nodes, segments);
	}

	private static Segment segment(final int id, final Node from, final Node to,
		final Polyline line) {
		return from.id() <= to.id()
			? new Segment(id, from, to, line)
			: new Segment(id, to, from, line.reversed());
	}

	/** @return the vertices, in scan order of their first pixels */
	public List<Node> nodes() {
		return nodes;
	}

	/** @return the edges, in scan order of their first points */
	public List<Segment> segments() {
		return segments;
	}

	/**
	 * @param node one of {@link #nodes()}
	 * @return the steps that leave it; a loop leaves it in both directions
	 */
	public List<Step> stepsFrom(final Node node) {
		return List.copyOf(stepsFrom.get(node.id()));
	}

	/** @return the number of junctions */
	public int junctions() {
		return (int) nodes.stream().filter(Node::isJunction).count();
	}

	/** @return the free ends */
	public List<Node> freeEnds() {
		return nodes.stream().filter(Node::isFreeEnd).toList();
	}

	/** @return whether it is a single chain with two free ends */
	public boolean isUnbranched() {
		return segments.size() == 1 && freeEnds().size() == 2;
	}

	/** @return the length of all segments together, in pixels */
	public double length() {
		return segments.stream().mapToDouble(Segment::length).sum();
	}

	/** @return the same as a JGraphT graph that cannot be changed */
	public Graph<Node, Segment> asGraph() {
		return new AsUnmodifiableGraph<>(graph);
	}
}
