
package io.github.knotresolver.mask;

import net.imglib2.RandomAccessibleInterval;
import net.imglib2.img.Img;
import net.imglib2.type.logic.BitType;
import net.imglib2.type.numeric.real.FloatType;

/** The published choice: Otsu's threshold of each frame. */
public final class Otsu implements Thresholder {

	@Override
	public Img<BitType> seed(final RandomAccessibleInterval<FloatType> frame) {
		return new FixedThreshold(OtsuThreshold.of(frame)).seed(frame);
	}
}
