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
 * @param ceiling for every pixel the brightness above which it does not say how bright what
 *          shone there was, since brighter ones were cut off; empty if none was
 * @param widening how many times as wide as usual lines are in it, above 0: it may be out of
 *          focus
 */
public record NormalizedFrame(int width, int height, double[] pixels, double[] ceiling,
	double widening) {

	private static final double[] NONE = {};

	/**
	 * A frame in focus, of which nothing was cut off.
	 *
	 * @param width in pixels
	 * @param height in pixels
	 * @param pixels row by row, {@code width * height} values; not to be changed
	 */
	public NormalizedFrame(final int width, final int height, final double[] pixels) {
		this(width, height, pixels, NONE, 1);
	}

	public NormalizedFrame {
		if (pixels.length != width * height)
			throw new IllegalArgumentException("A frame of " + width + " x " + height
				+ " pixels has " + pixels.length + " values.");
		if (ceiling.length != 0 && ceiling.length != pixels.length)
			throw new IllegalArgumentException("A frame of " + pixels.length
				+ " pixels has a ceiling of " + ceiling.length + ".");
	}

	/**
	 * @param heights for every pixel where it is cut off; not to be changed
	 * @return the same frame of which it is known
	 */
	public NormalizedFrame withCeiling(final double[] heights) {
		return new NormalizedFrame(width, height, pixels, heights, widening);
	}

	/**
	 * @param times how many times as wide as usual lines are, above 0
	 * @return the same frame of which it is known
	 */
	public NormalizedFrame withWidening(final double times) {
		return new NormalizedFrame(width, height, pixels, ceiling, times);
	}

	/** @return whether pixels were cut off anywhere in it */
	public boolean isClipped() {
		return ceiling.length > 0;
	}

	/** @return whether the pixel at a place in the frame was cut off */
	boolean isClipped(final double x, final double y) {
		final int at = (int) Math.rint(y) * width + (int) Math.rint(x);
		return isClipped() && pixels[at] >= ceiling[at];
	}

	/** @return whether a pixel does not say how bright what is drawn there is */
	boolean hides(final int at, final double drawn) {
		return ceiling.length > 0 && drawn > ceiling[at];
	}

	/** @return what the picture of lines that add up leaves of a pixel */
	double residual(final int at, final double drawn) {
		return hides(at, drawn) ? Math.min(0, pixels[at] - ceiling[at]) : pixels[at] - drawn;
	}

	/** @return what the picture of a line leaves; one that saturates is itself cut off */
	double residual(final int at, final double drawn, final LineModel model) {
		return model.kind() == LineModel.Kind.ADDITIVE
			? residual(at, drawn)
			: pixels[at] - drawn;
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
		final double[] heights = ceiling.clone();
		for (int i = 0; i < heights.length; i++)
			heights[i] = (ceiling[i] - background) / amplitude;
		return new NormalizedFrame(width, height, scaled, heights, widening);
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
		return new NormalizedFrame(width, height, blurred, ceiling, widening);
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
		final double[] cut = isClipped() ? new double[columns * rows] : NONE;
		for (int r = 0; r < rows && isClipped(); r++)
			System.arraycopy(ceiling, (top + r) * width + left, cut, r * columns, columns);
		return new NormalizedFrame(columns, rows, part, cut, widening);
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
