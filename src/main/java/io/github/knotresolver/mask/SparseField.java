
package io.github.knotresolver.mask;

import java.util.Arrays;

/**
 * A level set that knows its distance to the front only near the front:
 * positive inside, negative outside. The pixels on both sides of the front
 * carry its motion, and their distance is measured anew from where the level
 * set crosses zero; two layers beyond them follow at one and two pixels. Beyond
 * the border of the frame the outermost pixels are repeated.
 */
final class SparseField {

	private static final float FAR = 3;
	private static final int LAYERS = 3;

	private final int width;
	private final int height;
	private final float[] distance;
	/** 1 for the front, 2 and 3 for the layers beside it, 0 for all else. */
	private final byte[] layer;
	private final int[][] members = new int[LAYERS][];

	SparseField(final boolean[] mask, final int width) {
		this.width = width;
		this.height = mask.length / width;
		distance = new float[mask.length];
		layer = new byte[mask.length];
		for (int at = 0; at < mask.length; at++)
			distance[at] = mask[at] ? FAR : -FAR;
		final IntList front = new IntList();
		for (int at = 0; at < mask.length; at++)
			if (isAtFront(at))
				front.add(at);
		buildLayers(front.toArray());
	}

	int frontSize() {
		return members[0].length;
	}

	/** @return the place of a point of the front */
	int front(final int index) {
		return members[0][index];
	}

	boolean contains(final int at) {
		return distance[at] > 0;
	}

	/** @return which pixels are inside, row-major */
	boolean[] inside() {
		final boolean[] inside = new boolean[distance.length];
		for (int at = 0; at < inside.length; at++)
			inside[at] = contains(at);
		return inside;
	}

	/**
	 * @param steps pixels by which each point of the front moves outwards, at
	 *          most half a pixel
	 */
	void move(final float[] steps) {
		final int[] old = members[0];
		for (int i = 0; i < old.length; i++)
			distance[old[i]] += steps[i];
		measure(members[1], 1);
		final IntList front = new IntList();
		for (int k = 0; k < 2; k++)
			for (final int at : members[k])
				if (isAtFront(at))
					front.add(at);
		forgetLayers();
		buildLayers(front.toArray());
	}

	/**
	 * Curvature of the contour through a point, in 1/px, positive where the
	 * inside is convex; held within -1..1, the sharpest that pixels can show.
	 */
	double curvature(final int at) {
		final int x = at % width;
		final int y = at / width;
		final int west = x > 0 ? -1 : 0;
		final int east = x < width - 1 ? 1 : 0;
		final int north = y > 0 ? -width : 0;
		final int south = y < height - 1 ? width : 0;
		final double dx = (distance[at + east] - distance[at + west]) / 2;
		final double dy = (distance[at + south] - distance[at + north]) / 2;
		final double dxx = distance[at + east] - 2 * distance[at] + distance[at + west];
		final double dyy = distance[at + south] - 2 * distance[at] + distance[at + north];
		final double dxy = (distance[at + south + east] - distance[at + south + west]
			- distance[at + north + east] + distance[at + north + west]) / 4;
		final double slope = dx * dx + dy * dy;
		if (slope < 1e-6)
			return 0;
		final double curvature = -(dxx * dy * dy - 2 * dx * dy * dxy + dyy * dx * dx)
			/ (slope * Math.sqrt(slope));
		return Math.max(-1, Math.min(1, curvature));
	}

	private void forgetLayers() {
		for (final int[] points : members)
			for (final int at : points)
				layer[at] = 0;
	}

	private void buildLayers(final int[] front) {
		measureFront(front);
		for (final int at : front)
			layer[at] = 1;
		members[0] = front;
		for (int k = 1; k < LAYERS; k++) {
			members[k] = claimNeighbours(members[k - 1], k + 1);
			measure(members[k], k);
		}
	}

	/**
	 * Where the level set crosses zero between neighbours, there is the front.
	 */
	private void measureFront(final int[] front) {
		final float[] measured = new float[front.length];
		for (int i = 0; i < front.length; i++) {
			final int at = front[i];
			final float alongX = Math.min(toCrossing(at, 0), toCrossing(at, 2));
			final float alongY = Math.min(toCrossing(at, 1), toCrossing(at, 3));
			final float near = Math.min(alongX, alongY);
			final float far = Math.max(alongX, alongY);
			measured[i] = far > 1
				? near
				: (float) (near * far / Math.hypot(near, far + Float.MIN_NORMAL));
		}
		for (int i = 0; i < front.length; i++)
			distance[front[i]] = contains(front[i]) ? measured[i] : -measured[i];
	}

	/** @return pixels to the crossing in a direction; FAR if there is none */
	private float toCrossing(final int at, final int direction) {
		final int beside = neighbour(at, direction);
		if (contains(at) == contains(beside))
			return FAR;
		return distance[at] / (distance[at] - distance[beside]);
	}

	/** @return the free neighbours of a layer, now the next layer */
	private int[] claimNeighbours(final int[] points, final int next) {
		final IntList claimed = new IntList();
		for (final int at : points)
			for (int direction = 0; direction < 4; direction++) {
				final int beside = neighbour(at, direction);
				if (layer[beside] != 0)
					continue;
				layer[beside] = (byte) next;
				claimed.add(beside);
			}
		return claimed.toArray();
	}

	/** One pixel further from the front than the nearest in the layer before. */
	private void measure(final int[] points, final int before) {
		for (final int at : points) {
			final float side = contains(at) ? 1 : -1;
			float nearest = FAR;
			for (int direction = 0; direction < 4; direction++) {
				final int beside = neighbour(at, direction);
				if (layer[beside] == before)
					nearest = Math.min(nearest, side * distance[beside]);
			}
			distance[at] = side * (nearest + 1);
		}
	}

	private boolean isAtFront(final int at) {
		for (int direction = 0; direction < 4; direction++)
			if (contains(neighbour(at, direction)) != contains(at))
				return true;
		return false;
	}

	/** @return the neighbour; the pixel itself beyond the border */
	private int neighbour(final int at, final int direction) {
		final int x = at % width;
		return switch (direction) {
			case 0 -> x < width - 1 ? at + 1 : at;
			case 1 -> at >= width ? at - width : at;
			case 2 -> x > 0 ? at - 1 : at;
			default -> at < distance.length - width ? at + width : at;
		};
	}

	/** A growing list of places. */
	private static final class IntList {

		private int[] values = new int[64];
		private int size;

		void add(final int value) {
			if (size == values.length)
				values = Arrays.copyOf(values, 2 * size);
			values[size++] = value;
		}

		int[] toArray() {
			return Arrays.copyOf(values, size);
		}
	}
}
