package io.github.knotresolver.mask;

import net.imglib2.RandomAccessibleInterval;
import net.imglib2.type.logic.BitType;

import io.github.knotresolver.image.Pixels;

/** What is asked of the masks that come in. */
final class Masks {

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
}
