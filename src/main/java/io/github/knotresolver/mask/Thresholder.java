
package io.github.knotresolver.mask;

import net.imglib2.RandomAccessibleInterval;
import net.imglib2.img.Img;
import net.imglib2.type.logic.BitType;
import net.imglib2.type.numeric.real.FloatType;

/**
 * Where the active contour starts. Implementations have no state that changes,
 * so frames can be worked on in parallel.
 */
public interface Thresholder {

	/**
	 * @param frame a clean frame, 0..1
	 * @return which of its pixels start as filament
	 */
	Img<BitType> seed(RandomAccessibleInterval<FloatType> frame);
}
