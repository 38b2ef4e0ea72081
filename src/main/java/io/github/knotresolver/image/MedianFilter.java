
package io.github.knotresolver.image;

import static java.lang.Math.max;
import static java.lang.Math.min;

import net.imglib2.RandomAccessibleInterval;
import net.imglib2.img.Img;
import net.imglib2.type.numeric.real.FloatType;

/** Takes out noise of single pixels and keeps edges. */
public final class MedianFilter {

	private MedianFilter() {
	}

	/**
	 * The median of each pixel and its eight neighbours. Beyond the border the
	 * outermost pixels are repeated; pixels without a value (NaN) count as the
	 * lowest of the frame. O(n) for n pixels.
	 *
	 * @implNote op names="knotresolver.median"
	 * @param frame a two-dimensional image
	 * @return a new image of the same size
	 */
	public static Img<FloatType> median3x3(final RandomAccessibleInterval<FloatType> frame) {
		final int width = Pixels.width(frame);
		final int height = Pixels.height(frame);
		final float[] in = Pixels.floats(frame);
		final float[] out = new float[in.length];
		for (int y = 0; y < height; y++) {
			final int up = max(y - 1, 0) * width;
			final int here = y * width;
			final int down = min(y + 1, height - 1) * width;
			for (int x = 0; x < width; x++)
				out[here + x] = medianOfColumns(in, max(x - 1, 0), x, min(x + 1, width - 1), up,
					here, down);
		}
		return Pixels.image(out, width);
	}

	/**
	 * The median of nine is the middle one of: the largest of the columns'
	 * smallest, the middle of the columns' middles, the smallest of the columns'
	 * largest.
	 */
	private static float medianOfColumns(final float[] in, final int left, final int x,
		final int right, final int up, final int here, final int down) {
		final float a1 = in[up + left], a2 = in[here + left], a3 = in[down + left];
		final float b1 = in[up + x], b2 = in[here + x], b3 = in[down + x];
		final float c1 = in[up + right], c2 = in[here + right];
		final float c3 = in[down + right];
		final float lowest = max(max(min(min(a1, a2), a3), min(min(b1, b2), b3)),
			min(min(c1, c2), c3));
		final float middle = middle(middle(a1, a2, a3), middle(b1, b2, b3), middle(c1, c2, c3));
		final float highest = min(min(max(max(a1, a2), a3), max(max(b1, b2), b3)),
			max(max(c1, c2), c3));
		return middle(lowest, middle, highest);
	}

	private static float middle(final float a, final float b, final float c) {
		return max(min(a, b), min(max(a, b), c));
	}
}
