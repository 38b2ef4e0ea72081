package io.github.knotresolver.image;

/**
 * Filters along rows and columns; beyond the border the outermost pixels are
 * repeated.
 */
final class SeparableFilter {

	private SeparableFilter() {
	}

	/** @return a normalised Gaussian of {@code size} values, odd */
	static double[] gauss(final int size, final double sigma) {
		final double[] kernel = new double[size];
		double sum = 0;
		for (int i = 0; i < size; i++) {
			final double x = i - size / 2;
			kernel[i] = Math.exp(-x * x / (2 * sigma * sigma));
			sum += kernel[i];
		}
		for (int i = 0; i < size; i++)
			kernel[i] /= sum;
		return kernel;
	}

	/** @return rows filtered by a kernel of odd length */
	static float[] alongRows(final float[] in, final int width, final double[] kernel) {
		final int radius = kernel.length / 2;
		final float[] out = new float[in.length];
		for (int row = 0; row < in.length; row += width)
			for (int x = 0; x < width; x++) {
				double sum = 0;
				for (int k = 0; k < kernel.length; k++) {
					final int at = Math.min(Math.max(x + k - radius, 0), width - 1);
					sum += kernel[k] * in[row + at];
				}
				out[row + x] = (float) sum;
			}
		return out;
	}

	/** @return rows as columns */
	static float[] transposed(final float[] in, final int width) {
		final int height = in.length / width;
		final float[] out = new float[in.length];
		for (int y = 0; y < height; y++)
			for (int x = 0; x < width; x++)
				out[x * height + y] = in[y * width + x];
		return out;
	}
}
