
package io.github.knotresolver.image;

import net.imglib2.RandomAccessibleInterval;
import net.imglib2.img.Img;
import net.imglib2.type.numeric.RealType;
import net.imglib2.type.numeric.real.FloatType;

import io.github.knotresolver.model.Cleaning;

/**
 * Cleans frames: stretch, median and, if wanted, Laplacian of Gaussian. Has no
 * state, so frames can be cleaned in parallel.
 */
public final class FrameCleaner {

	/** Percentage of pixels saturated at either end of the intensities. */
	public static final double SATURATED_PERCENT = 1;

	private final Cleaning cleaning;

	/**
	 * @param cleaning how to clean
	 */
	public FrameCleaner(final Cleaning cleaning) {
		this.cleaning = cleaning;
	}

	/**
	 * @param frame one frame of any real type
	 * @return the clean frame of the same size, 0..1
	 */
	public Img<FloatType> clean(final RandomAccessibleInterval<? extends RealType<?>> frame) {
		final Img<FloatType> calm = MedianFilter
			.median3x3(ContrastStretch.saturate(frame, SATURATED_PERCENT, SATURATED_PERCENT));
		return cleaning.enhances()
			? LaplacianOfGaussian.enhance(calm, cleaning.logSize(), cleaning.logSigma())
			: calm;
	}
}
