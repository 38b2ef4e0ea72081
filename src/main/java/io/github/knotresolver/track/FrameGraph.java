package io.github.knotresolver.track;

import java.util.Objects;
import java.util.Optional;

import io.github.knotresolver.graph.SkeletonGraph;

/**
 * A frame as resolvers see it.
 *
 * @param frame 1-based number of the frame in the movie
 * @param graph its skeleton; empty if the filament was not found
 */
public record FrameGraph(int frame, Optional<SkeletonGraph> graph) {

	public FrameGraph {
		if (frame < 1)
			throw new IllegalArgumentException(
				"Frames count from 1, but this is frame " + frame + ".");
		Objects.requireNonNull(graph);
	}

	/** @return the number of junctions; 0 without a graph */
	public int junctions() {
		return graph.map(SkeletonGraph::junctions).orElse(0);
	}
}
