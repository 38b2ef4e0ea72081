package io.github.knotresolver.mask;

import net.imglib2.RandomAccessibleInterval;
import net.imglib2.img.Img;
import net.imglib2.type.logic.BitType;

import io.github.knotresolver.image.Pixels;

/** What masks have in common. */
public final class Masks {

	private Masks() {
	}

	static void requireSameSize(final RandomAccessibleInterval<?> frame,
		final RandomAccessibleInterval<BitType> mask) {
		requireSize(Pixels.width(frame), Pixels.height(frame), mask);
	}

	static void requireSize(final int width, final int height,
		final RandomAccessibleInterval<BitType> mask) {
		if (Pixels.width(mask) != width || Pixels.height(mask) != height)
			throw new IllegalArgumentException(
				"The mask must be as large as the frame, " + width + " x " + height
					+ " pixels, but is " + Pixels.width(mask) + " x " + Pixels.height(mask) + ".");
	}

	/**
	 * @param a a mask
	 * @param b a mask of the same size
	 * @return a new mask: the pixels that are in both
	 */
	public static Img<BitType> and(final RandomAccessibleInterval<BitType> a,
		final RandomAccessibleInterval<BitType> b) {
		requireSameSize(a, b);
		final boolean[] both = Pixels.bits(a), other = Pixels.bits(b);
		for (int at = 0; at < both.length; at++)
			both[at] &= other[at];
		return Pixels.mask(both, Pixels.width(a));
	}
}
