package io.github.knotresolver.graph;

import java.util.List;

import io.github.knotresolver.geometry.Point;

/**
 * A vertex of a {@link SkeletonGraph}.
 *
 * @param id index in {@link SkeletonGraph#nodes()}
 * @param kind what it is
 * @param position where it is, in pixels: the centroid of its pixels
 * @param pixels its pixels, in scan order
 */
public record Node(int id, Kind kind, Point position, List<Point> pixels) {

	/** What a vertex stands for. */
	public enum Kind {

		/** Branch pixels merged by 8-connectivity. */
		JUNCTION,
		/** A segment ends and touches nothing else. */
		FREE_END,
		/** The first pixel of a closed ring that has no junction. */
		RING,
		/** A point inside a segment that was asked for: the fixed end. */
		ANCHOR

	}

	public Node {
		pixels = List.copyOf(pixels);
	}

	/**
	 * @return whether segments meet here, as opposed to merely passing or ending
	 */
	public boolean isJunction() {
		return kind == Kind.JUNCTION;
	}

	/** @return whether exactly one segment ends here */
	public boolean isFreeEnd() {
		return kind == Kind.FREE_END;
	}

	/** The number: the same in every run, so that hashed order is too. */
	@Override
	public int hashCode() {
		return id;
	}
}
