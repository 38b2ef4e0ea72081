package io.github.knotresolver.mask;

import net.imglib2.RandomAccessibleInterval;
import net.imglib2.type.numeric.real.FloatType;

/** The published choice: Otsu's threshold of each frame. */
public final class Otsu implements Thresholder {

	@Override
	public Seed seed(final RandomAccessibleInterval<FloatType> frame) {
		return new Seed(frame, FixedThreshold.above(frame, OtsuThreshold.of(frame)));
	}
}
