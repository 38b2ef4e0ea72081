package io.github.knotresolver.track;

import java.util.Objects;
import java.util.Optional;

import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.graph.SkeletonGraph;
import io.github.knotresolver.model.FrameStatus;
import io.github.knotresolver.model.Observation;

/**
 * A frame as resolvers on skeletons alone see it: the skeleton of the filament that they follow.
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

	/**
	 * @param contour what the user gave for it, in pixels
	 * @return the frame with that contour
	 */
	public Observation corrected(final Polyline contour) {
		return new Observation(frame, FrameStatus.CORRECTED, Observation.GIVEN,
			Optional.of(contour), junctions(), 1, 0, 1);
	}

	/** @return the frame as one in which the filament was not found */
	public Observation lost() {
		return Observation.without(frame, FrameStatus.LOST, Observation.NOT_FOUND);
	}

	/** @return the frame as one whose skeleton gives no contour */
	public Observation withoutCandidates() {
		return Observation.without(frame, FrameStatus.UNRESOLVED,
			"The skeleton is too small to hold a contour.");
	}
}
