package io.github.knotresolver.image;

import net.imglib2.RandomAccessibleInterval;
import net.imglib2.img.Img;
import net.imglib2.type.numeric.RealType;
import net.imglib2.type.numeric.real.FloatType;

/** Makes a frame coarser. */
public final class Binning {

	private Binning() {
	}

	/**
	 * Means of blocks of pixels; columns and rows that do not fill a block are left out.
	 * The centre of the first block lies at {@code (factor - 1) / 2} pixels. Pixels
	 * without a value (NaN) count as the lowest of the frame. O(n) for n pixels.
	 *
	 * @implNote op names="knotresolver.bin"
	 * @param frame a two-dimensional image of at least one block
	 * @param factor edge of a block in pixels, at least 1
	 * @return a new image, {@code factor} times smaller along both axes
	 * @throws IllegalArgumentException if the frame has no whole block
	 */
	public static Img<FloatType> mean(final RandomAccessibleInterval<? extends RealType<?>> frame,
		final int factor) {
		final int width = Pixels.width(frame);
		return Pixels.image(mean(Pixels.floats(frame), width, factor), width / factor);
	}

	/**
	 * As {@link #mean(RandomAccessibleInterval, int)}.
	 *
	 * @param in pixels row by row, all with a value
	 * @param width of a row in pixels
	 * @param factor edge of a block in pixels, at least 1
	 * @return new pixels, in rows of {@code width / factor}
	 */
	public static float[] mean(final float[] in, final int width, final int factor) {
		final int columns = factor < 1 ? 0 : width / factor;
		final int rows = factor < 1 ? 0 : in.length / width / factor;
		if (columns == 0 || rows == 0)
			throw new IllegalArgumentException("A frame of " + width + " x " + in.length / width
				+ " pixels cannot be binned by " + factor + ".");
		if (factor == 1)
			return in.clone();
		final float[] out = new float[columns * rows];
		final float share = 1f / (factor * factor);
		for (int y = 0; y < rows * factor; y++)
			for (int column = 0; column < columns; column++)
				for (int x = column * factor; x < (column + 1) * factor; x++)
					out[y / factor * columns + column] += in[y * width + x];
		for (int i = 0; i < out.length; i++)
			out[i] *= share;
		return out;
	}
}
