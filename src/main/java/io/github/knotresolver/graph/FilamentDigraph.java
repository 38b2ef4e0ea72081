
package io.github.knotresolver.graph;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;

import org.jgrapht.Graph;
import org.jgrapht.graph.AsUnmodifiableGraph;
import org.jgrapht.graph.DirectedPseudograph;

import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.geometry.Polyline;

/**
 * The directed graph of the published method: junctions are branch vertices
 * V_b, segments are filament vertices V_f, and edges join a V_f to the V_b it
 * touches, both ways, except that nothing enters the start vertex and nothing
 * leaves the end vertex. A segment that touches the same junction twice (a loop
 * of the filament) is joined to it by two pairs of edges, one for each of its
 * ends.
 */
public final class FilamentDigraph {

	private final List<Label> labels = new ArrayList<>();
	private final Graph<Label, Contact> graph = new DirectedPseudograph<>(Contact.class);
	private final int start;
	private final int end;

	private FilamentDigraph(final SkeletonGraph skeleton, final Segment start,
		final Optional<Segment> end) {
		final Label[] branch = new Label[skeleton.nodes().size()];
		for (final Node n : skeleton.nodes())
			if (!n.isFreeEnd()) {
				branch[n.id()] = new Label(labels.size(), Optional.of(n), Optional.empty());
				labels.add(branch[n.id()]);
			}
		final int firstFilament = labels.size();
		this.start = firstFilament + start.id();
		this.end = end.map(s -> firstFilament + s.id()).orElse(-1);
		for (final Segment s : skeleton.segments())
			labels.add(new Label(labels.size(), Optional.empty(), Optional.of(s)));
		labels.forEach(graph::addVertex);
		for (final Segment s : skeleton.segments()) {
			final Label filament = labels.get(firstFilament + s.id());
			touch(filament, branch[s.source().id()], true);
			touch(filament, branch[s.target().id()], false);
		}
	}

	/**
	 * The digraph of a skeleton.
	 *
	 * @param skeleton its graph
	 * @param start the segment in which every path begins
	 * @param end the segment in which every path ends; empty if no end can be
	 *          seen
	 * @return the digraph
	 */
	public static FilamentDigraph of(final SkeletonGraph skeleton, final Segment start,
		final Optional<Segment> end) {
		return new FilamentDigraph(skeleton, start, end);
	}

	private void touch(final Label filament, final Label junction, final boolean atSource) {
		if (junction == null)
			return;
		if (filament.id() != start)
			connect(junction, filament, atSource);
		if (filament.id() != end)
			connect(filament, junction, atSource);
	}

	private void connect(final Label from, final Label to, final boolean atSource) {
		graph.addEdge(from, to, new Contact(graph.edgeSet().size(), from, to, atSource));
	}

	/** @return all vertices: the branch vertices, then the filament vertices */
	public List<Label> labels() {
		return List.copyOf(labels);
	}

	/** @return the vertex in which every path begins */
	public Label start() {
		return labels.get(start);
	}

	/** @return the vertex in which every path ends, if there is one */
	public Optional<Label> end() {
		return end < 0 ? Optional.empty() : Optional.of(labels.get(end));
	}

	/** @return the same as a JGraphT graph that cannot be changed */
	public Graph<Label, Contact> asGraph() {
		return new AsUnmodifiableGraph<>(graph);
	}

	/**
	 * A directed edge of the published method's digraph: where a segment touches a
	 * junction, walked one way.
	 *
	 * @param id its number, which makes parallel edges different
	 * @param from the vertex that is left
	 * @param to the vertex that is entered; one of the two is a branch vertex, the
	 *          other a filament vertex
	 * @param atSource whether it is the segment's source that touches the junction,
	 *          or its target
	 */
	public record Contact(int id, Label from, Label to, boolean atSource) {

		/** @return whether it leads from the junction into the segment */
		public boolean entersSegment() {
			return to.filament().isPresent();
		}

		/** The number: the same in every run, so that hashed order is too. */
		@Override
		public int hashCode() {
			return id;
		}
	}

	/**
	 * A vertex of the published method's digraph: a branch vertex (V_b) or a
	 * filament vertex (V_f).
	 *
	 * @param id index in {@link FilamentDigraph#labels()}
	 * @param branch the junction, if it is a branch vertex
	 * @param filament the segment, if it is a filament vertex
	 */
	public record Label(int id, Optional<Node> branch, Optional<Segment> filament) {

		/** @return the points it consists of, in pixels */
		public List<Point> points() {
			return branch.map(Node::pixels).orElseGet(() -> {
				final Polyline chain = filament.orElseThrow().chain();
				return IntStream.range(0, chain.size()).mapToObj(chain::point).toList();
			});
		}

		/** The number: the same in every run, so that hashed order is too. */
		@Override
		public int hashCode() {
			return id;
		}
	}
}
