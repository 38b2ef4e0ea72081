
package io.github.knotresolver.mask;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Predicate;

import net.imglib2.RandomAccessibleInterval;
import net.imglib2.img.Img;
import net.imglib2.type.logic.BitType;

import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.image.Pixels;

/** The connected objects of a mask. */
public final class ConnectedComponents {

	private final int width;
	private final int[] labels;
	private final List<MaskObject> objects;

	private ConnectedComponents(final int width, final int[] labels,
		final List<MaskObject> objects) {
		this.width = width;
		this.labels = labels;
		this.objects = List.copyOf(objects);
	}

	/**
	 * Finds the 8-connected objects. O(n).
	 *
	 * @param mask any mask
	 * @return its objects
	 */
	public static ConnectedComponents of(final RandomAccessibleInterval<BitType> mask) {
		return label(Pixels.bits(mask), Pixels.width(mask), true);
	}

	/** @param diagonal whether pixels that touch at a corner are connected */
	static ConnectedComponents label(final boolean[] bits, final int width,
		final boolean diagonal) {
		final int[] labels = new int[bits.length];
		final int[] stack = new int[bits.length];
		final List<MaskObject> objects = new ArrayList<>();
		for (int at = 0; at < bits.length; at++)
			if (bits[at] && labels[at] == 0)
				objects.add(fill(bits, width, diagonal, at, objects.size() + 1, labels, stack));
		return new ConnectedComponents(width, labels, objects);
	}

	private static MaskObject fill(final boolean[] bits, final int width, final boolean diagonal,
		final int start, final int label, final int[] labels, final int[] stack) {
		final int height = bits.length / width;
		int minX = width, minY = height, maxX = 0, maxY = 0, count = 0, top = 0;
		labels[start] = label;
		stack[top++] = start;
		while (top > 0) {
			final int at = stack[--top];
			final int x = at % width, y = at / width;
			count++;
			minX = Math.min(minX, x);
			minY = Math.min(minY, y);
			maxX = Math.max(maxX, x);
			maxY = Math.max(maxY, y);
			for (int v = Math.max(0, y - 1); v <= Math.min(height - 1, y + 1); v++)
				for (int u = Math.max(0, x - 1); u <= Math.min(width - 1, x + 1); u++) {
					final int beside = v * width + u;
					if (!bits[beside] || labels[beside] != 0 || !diagonal && u != x && v != y)
						continue;
					labels[beside] = label;
					stack[top++] = beside;
				}
		}
		return new MaskObject(label, count, minX, minY, maxX, maxY,
			minX == 0 || minY == 0 || maxX == width - 1 || maxY == height - 1);
	}

	/** @return the objects in the order of their labels */
	public List<MaskObject> objects() {
		return objects;
	}

	/**
	 * @param x column, 0-based
	 * @param y row, 0-based
	 * @return the object at a pixel, if there is one
	 */
	public Optional<MaskObject> at(final int x, final int y) {
		if (x < 0 || x >= width || y < 0 || y >= labels.length / width)
			return Optional.empty();
		return object(labels[y * width + x]);
	}

	/**
	 * @param point a place, inside the frame or not
	 * @return the object with the pixel nearest to it, the first label of several
	 *         equally near; empty if there is no object. O(n)
	 */
	public Optional<MaskObject> nearest(final Point point) {
		int best = 0;
		double nearest = Double.POSITIVE_INFINITY;
		for (int at = 0; at < labels.length; at++) {
			if (labels[at] == 0)
				continue;
			final double distance = point.distanceTo(new Point(at % width, at / width));
			if (distance > nearest || distance == nearest && labels[at] > best)
				continue;
			nearest = distance;
			best = labels[at];
		}
		return object(best);
	}

	/**
	 * @param point a place, inside the frame or not
	 * @param reach a distance in pixels
	 * @return the objects with a pixel no further away, in the order of their
	 *         labels. O(n)
	 */
	public List<MaskObject> near(final Point point, final double reach) {
		final boolean[] isNear = new boolean[objects.size() + 1];
		for (int at = 0; at < labels.length; at++)
			if (labels[at] != 0 && !isNear[labels[at]])
				isNear[labels[at]] = point.distanceTo(new Point(at % width, at / width)) <= reach;
		return objects.stream().filter(object -> isNear[object.label()]).toList();
	}

	/**
	 * @param mask a mask of the same size
	 * @return by label, how many pixels each object shares with it; the pixels of
	 *         no object at 0
	 */
	public int[] overlap(final RandomAccessibleInterval<BitType> mask) {
		Masks.requireSize(width, labels.length / width, mask);
		final boolean[] bits = Pixels.bits(mask);
		final int[] shared = new int[objects.size() + 1];
		for (int at = 0; at < labels.length; at++)
			if (bits[at])
				shared[labels[at]]++;
		return shared;
	}

	/**
	 * @param object one of the objects
	 * @return a mask of the frame's size with this object alone
	 */
	public Img<BitType> mask(final MaskObject object) {
		return mask(object::equals);
	}

	/**
	 * @param wanted which objects to keep
	 * @return a mask of the frame's size with these objects
	 */
	public Img<BitType> mask(final Predicate<MaskObject> wanted) {
		return Pixels.mask(bits(wanted), width);
	}

	boolean[] bits(final Predicate<MaskObject> wanted) {
		final boolean[] keep = new boolean[objects.size() + 1];
		for (final MaskObject object : objects)
			keep[object.label()] = wanted.test(object);
		final boolean[] bits = new boolean[labels.length];
		for (int at = 0; at < bits.length; at++)
			bits[at] = keep[labels[at]];
		return bits;
	}

	private Optional<MaskObject> object(final int label) {
		return label == 0 ? Optional.empty() : Optional.of(objects.get(label - 1));
	}

	/**
	 * One connected object of a mask.
	 *
	 * @param label its number, from 1 in the order in which a row-by-row scan meets
	 *          the objects
	 * @param pixels how many pixels it has
	 * @param minX leftmost column, 0-based
	 * @param minY topmost row, 0-based
	 * @param maxX rightmost column
	 * @param maxY bottommost row
	 * @param touchesBorder whether it reaches the border of the frame
	 */
	public record MaskObject(int label, int pixels, int minX, int minY, int maxX, int maxY,
		boolean touchesBorder) {
	}
}
