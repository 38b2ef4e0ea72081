package io.github.knotresolver.image;

import net.imglib2.RandomAccessibleInterval;
import net.imglib2.img.Img;
import net.imglib2.type.numeric.RealType;
import net.imglib2.type.numeric.real.FloatType;

/** Takes out single pixels that are unlike all of their surroundings. */
public final class HotPixels {

	private HotPixels() {
	}

	/**
	 * Every pixel is held between the second smallest and the second largest of its
	 * eight neighbours. On a line, however thin, two neighbours are about as bright as
	 * the pixel itself, so lines stay; a pixel that stands alone goes. The noise need not
	 * be known. Beyond the border the outermost pixels are repeated; pixels without a
	 * value (NaN) count as the lowest of the frame. O(n) for n pixels.
	 *
	 * @implNote op names="knotresolver.clipHotPixels"
	 * @param frame a two-dimensional image
	 * @return a new image of the same size
	 */
	public static Img<FloatType> clip(final RandomAccessibleInterval<? extends RealType<?>> frame) {
		return Pixels.image(clip(Pixels.floats(frame), Pixels.width(frame)), Pixels.width(frame));
	}

	/**
	 * As {@link #clip(RandomAccessibleInterval)}.
	 *
	 * @param in pixels row by row, all with a value
	 * @param width of a row in pixels
	 * @return new pixels
	 */
	public static float[] clip(final float[] in, final int width) {
		final int height = in.length / width;
		final float[] out = new float[in.length];
		final float[] around = new float[8];
		for (int y = 0; y < height; y++) {
			final int up = Math.max(y - 1, 0) * width, here = y * width;
			final int down = Math.min(y + 1, height - 1) * width;
			for (int x = 0; x < width; x++) {
				final int left = Math.max(x - 1, 0), right = Math.min(x + 1, width - 1);
				around[0] = in[up + left];
				around[1] = in[up + x];
				around[2] = in[up + right];
				around[3] = in[here + left];
				around[4] = in[here + right];
				around[5] = in[down + left];
				around[6] = in[down + x];
				around[7] = in[down + right];
				out[here + x] = held(in[here + x], around);
			}
		}
		return out;
	}

	private static float held(final float value, final float[] around) {
		float first = Float.NEGATIVE_INFINITY, second = Float.NEGATIVE_INFINITY;
		float last = Float.POSITIVE_INFINITY, secondLast = Float.POSITIVE_INFINITY;
		for (final float v : around) {
			second = Math.max(second, Math.min(first, v));
			first = Math.max(first, v);
			secondLast = Math.min(secondLast, Math.max(last, v));
			last = Math.min(last, v);
		}
		return Math.max(secondLast, Math.min(second, value));
	}
}
