package io.github.knotresolver.image;

/**
 * A smoothed frame and its second derivatives, all row by row. A linear slope of the
 * background has none.
 *
 * @param width of a row in pixels
 * @param smooth the frame convolved with a Gaussian
 * @param xx second derivative along x, per px²
 * @param xy mixed derivative
 * @param yy second derivative along y
 */
record Hessian(int width, float[] smooth, float[] xx, float[] xy, float[] yy) {

	/** The kernels end at so many standard deviations. */
	private static final double REACH = 4;

	/**
	 * Derivatives of a Gaussian, scaled so that they are exact for parabolas however
	 * narrow the Gaussian is. O(n sigma) for n pixels.
	 *
	 * @param pixels row by row, all with a value
	 * @param width of a row in pixels
	 * @param sigma standard deviation of the Gaussian in pixels, above 0
	 */
	static Hessian of(final float[] pixels, final int width, final double sigma) {
		final int radius = (int) (REACH * sigma + 0.5);
		final double[] gauss = SeparableFilter.gauss(2 * radius + 1, sigma);
		final double[] first = first(gauss), second = second(gauss);
		final float[] calm = SeparableFilter.columns(pixels, width, gauss);
		return new Hessian(width, SeparableFilter.rows(calm, width, gauss),
			SeparableFilter.rows(calm, width, second),
			SeparableFilter.rows(SeparableFilter.columns(pixels, width, first), width, first),
			SeparableFilter.rows(SeparableFilter.columns(pixels, width, second), width, gauss));
	}

	int height() {
		return smooth.length / width;
	}

	/** @return the same for the frame with its brightness multiplied by a sign */
	Hessian signed(final int sign) {
		return sign == 1
			? this
			: new Hessian(width, negative(smooth), negative(xx), negative(xy), negative(yy));
	}

	private static float[] negative(final float[] values) {
		final float[] negative = new float[values.length];
		for (int i = 0; i < values.length; i++)
			negative[i] = -values[i];
		return negative;
	}

	/** Correlated with a slope of 1 it gives 1. */
	private static double[] first(final double[] gauss) {
		final double variance = moment(gauss, 2);
		final double[] kernel = new double[gauss.length];
		for (int i = 0; i < kernel.length; i++)
			kernel[i] = (i - kernel.length / 2) * gauss[i] / variance;
		return kernel;
	}

	/** Correlated with a constant it gives 0, with x²/2 it gives 1. */
	private static double[] second(final double[] gauss) {
		final double variance = moment(gauss, 2);
		final double scale = (moment(gauss, 4) - variance * variance) / 2;
		final double[] kernel = new double[gauss.length];
		for (int i = 0; i < kernel.length; i++) {
			final double x = i - kernel.length / 2;
			kernel[i] = (x * x - variance) * gauss[i] / scale;
		}
		return kernel;
	}

	private static double moment(final double[] kernel, final int power) {
		double sum = 0;
		for (int i = 0; i < kernel.length; i++)
			sum += Math.pow(i - kernel.length / 2, power) * kernel[i];
		return sum;
	}
}
