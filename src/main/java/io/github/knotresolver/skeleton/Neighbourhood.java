
package io.github.knotresolver.skeleton;

import java.util.Arrays;

import net.imglib2.RandomAccessibleInterval;
import net.imglib2.type.logic.BitType;

import io.github.knotresolver.image.Pixels;

/**
 * A mask with a frame of background around it, so that every pixel has eight
 * neighbours. A pixel's neighbours are one byte: bit 0 is east, and the others
 * follow around, north-east, north, ... south-east.
 */
final class Neighbourhood {

	private final int width;
	private final int height;
	private final boolean[] bits;
	private final int[] steps;
	/** Places outside of which nothing is in the mask, row by row; null if they must be looked for. */
	private int[] candidates;

	Neighbourhood(final RandomAccessibleInterval<BitType> mask) {
		width = Pixels.width(mask);
		height = Pixels.height(mask);
		final int stride = width + 2;
		steps = new int[]{1, 1 - stride, -stride, -1 - stride, -1, stride - 1, stride, stride + 1};
		bits = new boolean[stride * (height + 2)];
		final boolean[] inside = Pixels.bits(mask);
		for (int y = 0; y < height; y++)
			System.arraycopy(inside, y * width, bits, (y + 1) * stride + 1, width);
	}

	/** @return the places of the mask's pixels, row by row; a new array */
	int[] pixels() {
		final int[] pixels = candidates == null ? all() : candidates.clone();
		int count = 0;
		for (final int at : pixels)
			if (bits[at])
				pixels[count++] = at;
		candidates = Arrays.copyOf(pixels, count);
		return Arrays.copyOf(pixels, count);
	}

	private int[] all() {
		int count = 0;
		for (final boolean bit : bits)
			if (bit)
				count++;
		final int[] all = new int[count];
		for (int at = 0, next = 0; at < bits.length; at++)
			if (bits[at])
				all[next++] = at;
		return all;
	}

	/** @return the neighbours of a place as one byte, 0..255 */
	int around(final int at) {
		int around = 0;
		for (int k = 0; k < 8; k++)
			if (bits[at + steps[k]])
				around |= 1 << k;
		return around;
	}

	/** @return whether the neighbour in a direction, 0..7, is in the mask */
	boolean has(final int at, final int direction) {
		return bits[at + steps[direction]];
	}

	/** @return whether a place is in the mask */
	boolean has(final int at) {
		return bits[at];
	}

	/** @return the place of the neighbour in a direction, 0..7 */
	int neighbour(final int at, final int direction) {
		return at + steps[direction];
	}

	/** @return the number of places */
	int places() {
		return bits.length;
	}

	void add(final int x, final int y) {
		candidates = null;
		bits[(y + 1) * (width + 2) + x + 1] = true;
	}

	void remove(final int at) {
		bits[at] = false;
	}

	/** @return the mask without its frame, row-major */
	boolean[] toBits() {
		final boolean[] inside = new boolean[width * height];
		for (int y = 0; y < height; y++)
			System.arraycopy(bits, (y + 1) * (width + 2) + 1, inside, y * width, width);
		return inside;
	}

	/** @return where a place lies in {@link #toBits()} */
	int inside(final int at) {
		final int stride = width + 2;
		return (at / stride - 1) * width + at % stride - 1;
	}

	int width() {
		return width;
	}
}
