package io.github.knotresolver.fit;

import io.github.knotresolver.image.GaussianBlur;
import io.github.knotresolver.image.PixelNoise;

/**
 * A frame above its background, which is 0. The fit takes it {@link #rescaled} to a single
 * bright strand of 1; before that it is in the movie's grey values.
 *
 * @param width in pixels
 * @param height in pixels
 * @param pixels row by row, {@code width * height} values; not to be changed
 */
public record NormalizedFrame(int width, int height, double[] pixels) {

	public NormalizedFrame {
		if (pixels.length != width * height)
			throw new IllegalArgumentException("A frame of " + width + " x " + height
				+ " pixels has " + pixels.length + " values.");
	}

	/**
	 * @param background the value that becomes 0
	 * @param amplitude the height above it that becomes 1
	 * @return the frame in new units
	 */
	public NormalizedFrame rescaled(final double background, final double amplitude) {
		final double[] scaled = new double[pixels.length];
		for (int i = 0; i < scaled.length; i++)
			scaled[i] = (pixels[i] - background) / amplitude;
		return new NormalizedFrame(width, height, scaled);
	}

	/**
	 * @param sigma of a Gaussian in pixels, above 0
	 * @return the frame blurred by it
	 */
	public NormalizedFrame blurred(final double sigma) {
		final float[] in = new float[pixels.length];
		for (int i = 0; i < in.length; i++)
			in[i] = (float) pixels[i];
		final float[] out = GaussianBlur.blur(in, width, sigma);
		final double[] blurred = new double[pixels.length];
		for (int i = 0; i < blurred.length; i++)
			blurred[i] = out[i];
		return new NormalizedFrame(width, height, blurred);
	}

	/**
	 * A part of the frame.
	 *
	 * @param left first column
	 * @param top first row
	 * @param columns how many, at least 1
	 * @param rows how many, at least 1
	 * @return that part; it must lie inside the frame
	 */
	NormalizedFrame window(final int left, final int top, final int columns, final int rows) {
		final double[] part = new double[columns * rows];
		for (int r = 0; r < rows; r++)
			System.arraycopy(pixels, (top + r) * width + left, part, r * columns, columns);
		return new NormalizedFrame(columns, rows, part);
	}

	/** @return the {@link PixelNoise} of the frame */
	public double noise() {
		return PixelNoise.of(pixels, width);
	}

	/**
	 * @param x column in pixels
	 * @param y row in pixels
	 * @return the mean of the 3 x 3 pixels around the nearest one, as far as they are in
	 *         the frame; NaN if none is
	 */
	public double meanAround(final double x, final double y) {
		final int column = (int) Math.rint(x), row = (int) Math.rint(y);
		double sum = 0;
		int count = 0;
		for (int r = Math.max(0, row - 1); r <= Math.min(height - 1, row + 1); r++)
			for (int c = Math.max(0, column - 1); c <= Math.min(width - 1, column + 1); c++) {
				sum += pixels[r * width + c];
				count++;
			}
		return sum / count;
	}
}
