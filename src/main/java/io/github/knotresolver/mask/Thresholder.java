package io.github.knotresolver.mask;

import net.imglib2.RandomAccessibleInterval;
import net.imglib2.type.logic.BitType;
import net.imglib2.type.numeric.real.FloatType;

/**
 * Finds what is bright enough to be filament. Implementations have no state
 * that changes, so frames can be worked on in parallel.
 */
public interface Thresholder {

	/**
	 * Where and in what the active contour starts.
	 *
	 * @param frame the intensities it moves in: the clean frame, or one made from
	 *          it
	 * @param mask the mask it starts from, of the same size
	 */
	record Seed(RandomAccessibleInterval<FloatType> frame, RandomAccessibleInterval<BitType> mask) {
	}

	/**
	 * @param frame a clean frame, 0..1
	 * @return where the active contour starts
	 */
	Seed seed(RandomAccessibleInterval<FloatType> frame);
}
