package io.github.knotresolver.graph;

import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.geometry.Polyline;

/**
 * A segment walked in one direction.
 *
 * @param segment the segment
 * @param forward from its source to its target, or the other way
 */
public record Step(Segment segment, boolean forward) {

	/** @return where the step begins */
	public Node from() {
		return forward ? segment.source() : segment.target();
	}

	/** @return where the step ends */
	public Node to() {
		return forward ? segment.target() : segment.source();
	}

	/** @return length in pixels */
	public double length() {
		return segment.length();
	}

	/** @return the smoothed curve in the direction of the step, node to node */
	public Polyline curve() {
		return forward ? segment.curve() : segment.curve().reversed();
	}

	/** @return the pixel chain in the direction of the step, node to node */
	public Polyline chain() {
		return forward ? segment.chain() : segment.chain().reversed();
	}

	/** @return unit vector of walking at the step's beginning */
	public Point departure() {
		return forward ? segment.sourceTangent() : segment.targetTangent();
	}

	/** @return unit vector of walking at the step's end */
	public Point arrival() {
		final Point t = forward ? segment.targetTangent() : segment.sourceTangent();
		return new Point(-t.x(), -t.y());
	}

	/**
	 * @param other a step
	 * @return whether the other step walks the same segment the other way
	 */
	public boolean isReverseOf(final Step other) {
		return segment == other.segment && forward != other.forward;
	}
}
