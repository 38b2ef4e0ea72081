
package io.github.knotresolver.mask;

import net.imglib2.RandomAccessibleInterval;
import net.imglib2.img.Img;
import net.imglib2.type.logic.BitType;

import io.github.knotresolver.image.Pixels;

/** Takes out of a mask what is not a filament. Inputs are not changed. */
public final class MaskRepair {

	private MaskRepair() {
	}

	/**
	 * Fills small 4-connected holes. The loop of a filament may be small, so the
	 * size should be, too.
	 *
	 * @implNote op names="knotresolver.fillPinHoles"
	 * @param mask any mask
	 * @param pixels size up to which holes are filled
	 * @return a new mask without pin holes
	 */
	public static Img<BitType> fillPinHoles(final RandomAccessibleInterval<BitType> mask,
		final int pixels) {
		final boolean[] filled = Pixels.bits(mask);
		fillPinHoles(filled, Pixels.width(mask), pixels);
		return Pixels.mask(filled, Pixels.width(mask));
	}

	/** A hole's first pixel has the mask at its left, so only there is looked; as far as a pin hole can reach. */
	static void fillPinHoles(final boolean[] mask, final int width, final int pixels) {
		final boolean[] original = mask.clone();
		final int[] hole = new int[pixels + 1];
		for (int at = 1; at < original.length; at++)
			if (original[at - 1] && !original[at] && !mask[at]) {
				final int size = hole(original, width, at, hole);
				for (int i = 0; i < size; i++)
					mask[hole[i]] = true;
			}
	}

	/** @return number of pixels of the hole at a place; 0 if it is larger than the array, or open to the border */
	private static int hole(final boolean[] mask, final int width, final int start,
		final int[] hole) {
		final int height = mask.length / width;
		int count = 0;
		hole[count++] = start;
		for (int i = 0; i < count; i++) {
			final int x = hole[i] % width, y = hole[i] / width;
			if (count == hole.length || x == 0 || y == 0 || x == width - 1 || y == height - 1)
				return 0;
			for (final int beside : new int[]{hole[i] - width, hole[i] - 1, hole[i] + 1,
				hole[i] + width})
				if (!mask[beside] && !contains(hole, count, beside)) {
					if (count == hole.length)
						return 0;
					hole[count++] = beside;
				}
		}
		return count == hole.length ? 0 : count;
	}

	private static boolean contains(final int[] places, final int count, final int place) {
		for (int i = 0; i < count; i++)
			if (places[i] == place)
				return true;
		return false;
	}

	/**
	 * Removes small 8-connected objects.
	 *
	 * @implNote op names="knotresolver.removeSpecks"
	 * @param mask any mask
	 * @param pixels size below which 8-connected objects go
	 * @return a new mask without specks
	 */
	public static Img<BitType> removeSpecks(final RandomAccessibleInterval<BitType> mask,
		final int pixels) {
		return ConnectedComponents.of(mask).mask(object -> object.pixels() >= pixels);
	}

	/**
	 * Removes objects that touch the border.
	 *
	 * @implNote op names="knotresolver.dropBorderObjects"
	 * @param mask any mask
	 * @return a new mask without the objects that touch the border of the frame
	 */
	public static Img<BitType> dropBorderObjects(final RandomAccessibleInterval<BitType> mask) {
		return ConnectedComponents.of(mask).mask(object -> !object.touchesBorder());
	}
}
