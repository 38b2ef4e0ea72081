package io.github.knotresolver.mask;

import net.imglib2.RandomAccessibleInterval;
import net.imglib2.type.logic.BitType;
import net.imglib2.type.numeric.real.FloatType;

/**
 * Where and in what the active contour starts.
 *
 * @param frame the intensities it moves in: the clean frame, or one made from
 *          it
 * @param mask the mask it starts from, of the same size
 */
public record Seed(RandomAccessibleInterval<FloatType> frame,
	RandomAccessibleInterval<BitType> mask) {
}
