package io.github.knotresolver.candidate;

import java.util.Objects;
import java.util.Optional;
import java.util.OptionalDouble;

import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.graph.SkeletonGraph;

/**
 * What a generator may know about a frame.
 *
 * @param graph the frame's skeleton
 * @param fixedEnd the fixed end in pixels
 * @param length the filament's length in pixels, above 0; empty if not known
 * @param template the last resolved contour; empty if there is none
 */
public record CandidateQuery(SkeletonGraph graph, Point fixedEnd, OptionalDouble length,
	Optional<Polyline> template) {

	public CandidateQuery {
		Objects.requireNonNull(graph);
		Objects.requireNonNull(fixedEnd);
		Objects.requireNonNull(template);
		if (length.isPresent() && !(length.getAsDouble() > 0))
			throw new IllegalArgumentException(
				"The filament's length must be above 0 pixels, but is " + length.getAsDouble()
					+ ".");
	}

	/**
	 * A query without a template.
	 *
	 * @param graph the frame's skeleton
	 * @param fixedEnd the fixed end in pixels
	 * @param length the filament's length in pixels; empty if not known
	 * @return the query
	 */
	public static CandidateQuery of(final SkeletonGraph graph, final Point fixedEnd,
		final OptionalDouble length) {
		return new CandidateQuery(graph, fixedEnd, length, Optional.empty());
	}
}
