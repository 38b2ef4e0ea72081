
package io.github.knotresolver.graph;

import io.github.knotresolver.geometry.GaussianSmoothing;
import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.geometry.Polyline;

/**
 * An edge of a {@link SkeletonGraph}: an ordered chain of pixels from its
 * source to its target. Which of its two ends is called the source means
 * nothing.
 */
public final class Segment {

	private final int id;
	private final Node source;
	private final Node target;
	private final Polyline chain;
	private final Polyline curve;
	private final Point sourceTangent;
	private final Point targetTangent;

	/**
	 * @param id index in {@link SkeletonGraph#segments()}
	 * @param chain the pixels from source to target, both nodes' positions
	 *          included
	 */
	Segment(final int id, final Node source, final Node target, final Polyline chain) {
		this.id = id;
		this.source = source;
		this.target = target;
		this.chain = chain;
		curve = chain.size() > 2 ? GaussianSmoothing.gaussian(chain, GraphTuning.STAIRCASE) : chain;
		sourceTangent = tangent(curve);
		targetTangent = tangent(curve.reversed());
	}

	/**
	 * The direction in which a curve leaves its first point, over some pixels
	 * beyond the reach of the junction.
	 */
	private static Point tangent(final Polyline curve) {
		final double from = Math.min(GraphTuning.JUNCTION_BEND, curve.length() / 4);
		final Point a = curve.at(from), b = curve.at(from + GraphTuning.TANGENT);
		final double d = a.distanceTo(b);
		return d > 0 ? new Point((b.x() - a.x()) / d, (b.y() - a.y()) / d) : new Point(0, 0);
	}

	/** @return index in {@link SkeletonGraph#segments()} */
	public int id() {
		return id;
	}

	/** @return the node at the chain's first point */
	public Node source() {
		return source;
	}

	/** @return the node at the chain's last point */
	public Node target() {
		return target;
	}

	/** @return whether both ends are at the same node */
	public boolean isLoop() {
		return source.id() == target.id();
	}

	/**
	 * @return the pixels' centres from source to target, with the positions of
	 *         both nodes as first and last point
	 */
	public Polyline chain() {
		return chain;
	}

	/** @return the chain, lightly smoothed, from node to node */
	public Polyline curve() {
		return curve;
	}

	/** @return length of {@link #curve()} in pixels */
	public double length() {
		return curve.length();
	}

	/** @return unit vector in which the segment leaves its source */
	Point sourceTangent() {
		return sourceTangent;
	}

	/** @return unit vector in which the segment leaves its target */
	Point targetTangent() {
		return targetTangent;
	}

	@Override
	public boolean equals(final Object other) {
		return this == other;
	}

	/** The number: the same in every run, so that hashed order is too. */
	@Override
	public int hashCode() {
		return id;
	}

	@Override
	public String toString() {
		return "Segment " + id + " from node " + source.id() + " to node " + target.id() + ", "
			+ length() + " px";
	}
}
