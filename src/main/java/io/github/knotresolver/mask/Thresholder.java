package io.github.knotresolver.mask;

import net.imglib2.RandomAccessibleInterval;
import net.imglib2.type.numeric.real.FloatType;

/**
 * Finds what is bright enough to be filament. Implementations have no state
 * that changes, so frames can be worked on in parallel.
 */
public interface Thresholder {

	/**
	 * @param frame a clean frame, 0..1
	 * @return where the active contour starts
	 */
	Seed seed(RandomAccessibleInterval<FloatType> frame);
}
