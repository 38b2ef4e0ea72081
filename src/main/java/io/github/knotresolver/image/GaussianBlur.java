package io.github.knotresolver.image;

/** Takes the noise of single pixels from a frame, and some sharpness with it. */
public final class GaussianBlur {

	/** The kernel ends at so many standard deviations, rounded up to a pixel. */
	public static final double REACH = 4;

	private GaussianBlur() {
	}

	/**
	 * The frame convolved with a Gaussian. Beyond the border the outermost pixels
	 * are repeated. O(n sigma) for n pixels.
	 *
	 * @param pixels row by row, all with a value
	 * @param width in pixels
	 * @param sigma standard deviation of the Gaussian in pixels, above 0
	 * @return the blurred pixels
	 */
	public static float[] blur(final float[] pixels, final int width, final double sigma) {
		final double[] gauss = SeparableFilter.gauss(2 * (int) Math.ceil(REACH * sigma) + 1, sigma);
		final int height = pixels.length / width;
		return SeparableFilter
			.transposed(
				SeparableFilter.alongRows(SeparableFilter.transposed(
					SeparableFilter.alongRows(pixels, width, gauss), width), height, gauss),
				height);
	}
}
