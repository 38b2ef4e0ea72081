package io.github.knotresolver.graph;

import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;

import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.geometry.Polyline;

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
