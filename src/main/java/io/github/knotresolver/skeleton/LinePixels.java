package io.github.knotresolver.skeleton;

import java.util.Arrays;

import net.imglib2.RandomAccessibleInterval;
import net.imglib2.img.Img;
import net.imglib2.type.logic.BitType;

import io.github.knotresolver.image.Pixels;

/** Lines one pixel wide that can be walked along and cut. Places are those of {@link Neighbourhood}. */
final class LinePixels {

	private final Neighbourhood line;

	/** @param mask is thinned */
	LinePixels(final RandomAccessibleInterval<BitType> mask) {
		line = new Neighbourhood(mask);
		Skeletonize.thin(line);
	}

	/** @return the places of all pixels, row by row */
	int[] pixels() {
		return line.pixels();
	}

	/** @return where a place lies in an image, row by row */
	int inside(final int at) {
		return line.inside(at);
	}

	boolean isEnd(final int at) {
		return line.has(at) && Integer.bitCount(line.around(at)) == 1;
	}

	boolean has(final int at) {
		return line.has(at);
	}

	/** @return the free ends, row by row */
	int[] ends() {
		final int[] pixels = line.pixels();
		int count = 0;
		for (final int at : pixels)
			if (isEnd(at))
				pixels[count++] = at;
		return Arrays.copyOf(pixels, count);
	}

	/**
	 * @param end a free end
	 * @param most pixels at most
	 * @return the pixels from there on, up to where lines meet, without that
	 */
	int[] walk(final int end, final int most) {
		final int[] path = new int[most];
		int count = 0;
		int before = -1, at = end;
		while (at >= 0 && count < most && Integer.bitCount(line.around(at)) <= 2) {
			path[count++] = at;
			final int next = next(at, before);
			before = at;
			at = next;
		}
		return Arrays.copyOf(path, count);
	}

	/** @return whether lines meet where a walk came to its end */
	boolean meetsAfter(final int[] walk) {
		if (walk.length == 0)
			return false;
		final int before = walk.length > 1 ? walk[walk.length - 2] : -1;
		return next(walk[walk.length - 1], before) >= 0;
	}

	private int next(final int at, final int before) {
		for (int k = 0; k < 8; k++)
			if (line.has(at, k) && line.neighbour(at, k) != before)
				return line.neighbour(at, k);
		return -1;
	}

	/** @return the number of places */
	int places() {
		return line.places();
	}

	/** @return the place of the neighbour in a direction, 0..7 */
	int neighbour(final int at, final int direction) {
		return line.neighbour(at, direction);
	}

	void remove(final int at) {
		line.remove(at);
	}

	/** Removes the pixels of a walk, and the stump that it leaves where lines met. */
	void cut(final int[] walk) {
		for (final int at : walk)
			line.remove(at);
		final int last = walk[walk.length - 1];
		for (int k = 0; k < 8; k++) {
			final int at = line.neighbour(last, k);
			if (line.has(at) && Skeletonize.isRemovable(line.around(at)))
				line.remove(at);
		}
	}

	/** Draws a straight line between two pixels. */
	void draw(final int from, final int to) {
		final int width = line.width(), a = line.inside(from), b = line.inside(to);
		final int dx = b % width - a % width, dy = b / width - a / width;
		final int steps = Math.max(Math.abs(dx), Math.abs(dy));
		for (int i = 0; i <= steps; i++)
			line.add(a % width + (int) Math.rint((double) i * dx / steps),
				a / width + (int) Math.rint((double) i * dy / steps));
	}

	/** Corners that cutting or drawing left are taken out. */
	void thin() {
		Skeletonize.thin(line);
	}

	boolean[] bits() {
		return line.toBits();
	}

	Img<BitType> image() {
		return Pixels.mask(line.toBits(), line.width());
	}

	int width() {
		return line.width();
	}
}
