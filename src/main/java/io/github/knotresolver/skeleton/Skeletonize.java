
package io.github.knotresolver.skeleton;

import java.util.Arrays;

import net.imglib2.RandomAccessibleInterval;
import net.imglib2.img.Img;
import net.imglib2.type.logic.BitType;

import io.github.knotresolver.image.Pixels;
import io.github.knotresolver.progress.Cancellation;

/** Thins a mask to its medial line. */
public final class Skeletonize {

	private static final int NORTH = 2, WEST = 4, SOUTH = 6, EAST = 0;

	/** By the byte of neighbours: whether the pixel may go. */
	private static final boolean[] REMOVABLE = removable();

	private Skeletonize() {
	}

	/**
	 * Peels the mask from the north, south, east and west in turn until nothing
	 * can go: a pixel goes if it is simple (its removal neither parts nor joins
	 * anything, nor opens or closes a hole) and is not the end of a line. The
	 * pixels of one side are found together and removed one by one, each tested
	 * again before it goes, so the line has exactly as many 8-connected parts and
	 * 4-connected holes as the mask. No corner of a staircase remains: a plain
	 * line has no pixel with more than two neighbours. Thinning a skeleton
	 * changes nothing. O(n w) for n mask pixels and an object w pixels wide.
	 * <p>
	 * The two-dimensional case of Lee, Kashyap and Chu 1994,
	 * doi:10.1006/cgip.1994.1042.
	 *
	 * @implNote op names="knotresolver.skeletonize"
	 * @param mask any number of objects, which may touch the border
	 * @return a new mask of the same size: the lines
	 */
	public static Img<BitType> thin(final RandomAccessibleInterval<BitType> mask) {
		final Neighbourhood line = new Neighbourhood(mask);
		thin(line);
		return Pixels.mask(line.toBits(), line.width());
	}

	/** As {@link #thin(RandomAccessibleInterval)}, in place. */
	static void thin(final Neighbourhood line) {
		int[] pixels = line.pixels();
		int before;
		do {
			Cancellation.check();
			before = pixels.length;
			for (final int side : new int[]{NORTH, SOUTH, EAST, WEST})
				pixels = peel(line, pixels, side);
		} while (pixels.length < before);
	}

	/** @return whether a pixel with such neighbours may go without changing the topology or an end */
	static boolean isRemovable(final int around) {
		return REMOVABLE[around];
	}

	/** @return the pixels that remain */
	private static int[] peel(final Neighbourhood line, final int[] pixels, final int side) {
		final boolean[] candidate = new boolean[pixels.length];
		for (int i = 0; i < pixels.length; i++)
			candidate[i] = !line.has(pixels[i], side) && REMOVABLE[line.around(pixels[i])];
		final int[] remaining = new int[pixels.length];
		int count = 0;
		for (int i = 0; i < pixels.length; i++) {
			if (candidate[i] && REMOVABLE[line.around(pixels[i])])
				line.remove(pixels[i]);
			else
				remaining[count++] = pixels[i];
		}
		return Arrays.copyOf(remaining, count);
	}

	private static boolean[] removable() {
		final boolean[] removable = new boolean[256];
		for (int around = 0; around < 256; around++)
			removable[around] = Integer.bitCount(around) > 1 && isSimple(around);
		return removable;
	}

	/** Yokoi's connectivity number for 8-connected objects is 1. */
	private static boolean isSimple(final int around) {
		int number = 0;
		for (int k = 0; k < 8; k += 2) {
			final boolean first = isBackground(around, k);
			final boolean corner = isBackground(around, k + 1);
			final boolean second = isBackground(around, k + 2);
			if (first && !(corner && second))
				number++;
		}
		return number == 1;
	}

	private static boolean isBackground(final int around, final int direction) {
		return (around >> (direction & 7) & 1) == 0;
	}
}
