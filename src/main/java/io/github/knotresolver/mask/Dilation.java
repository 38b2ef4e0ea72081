package io.github.knotresolver.mask;

import java.util.Arrays;

import net.imglib2.RandomAccessibleInterval;
import net.imglib2.img.Img;
import net.imglib2.type.logic.BitType;

import io.github.knotresolver.image.Pixels;

/** Widens masks. */
public final class Dilation {

	private Dilation() {
	}

	/**
	 * Widens a mask by a square. O(n + m radius) for n pixels, m of them in the mask.
	 *
	 * @implNote op names="knotresolver.dilate"
	 * @param mask any mask
	 * @param radius in pixels, at least 0: the edge of the square is twice that, and one
	 * @return a new mask of the same size
	 */
	public static Img<BitType> square(final RandomAccessibleInterval<BitType> mask,
		final int radius) {
		return Pixels.mask(square(Pixels.bits(mask), Pixels.width(mask), radius),
			Pixels.width(mask));
	}

	/**
	 * As {@link #square(RandomAccessibleInterval, int)}.
	 *
	 * @param bits row by row
	 * @param width of a row
	 * @param radius in pixels, at least 0
	 * @return the wider mask, row by row
	 */
	public static boolean[] square(final boolean[] bits, final int width, final int radius) {
		final int height = bits.length / width;
		final boolean[] rows = new boolean[bits.length], all = new boolean[bits.length];
		for (int at = 0; at < bits.length; at++)
			if (bits[at]) {
				final int row = at - at % width, x = at % width;
				Arrays.fill(rows, row + Math.max(0, x - radius),
					row + Math.min(width - 1, x + radius) + 1, true);
			}
		for (int at = 0; at < bits.length; at++)
			if (rows[at])
				for (int y = Math.max(0, at / width - radius); y <= Math.min(height - 1,
					at / width + radius); y++)
					all[y * width + at % width] = true;
		return all;
	}
}
