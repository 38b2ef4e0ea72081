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
		final Row row = new Row(width);
		for (int y = 0; y < height; y++)
			row.clip(in, Math.max(y - 1, 0) * width, y * width, Math.min(y + 1, height - 1) * width,
				out);
		return out;
	}

	/** Works on a row at a time, without branches. Beyond the border its pixels are repeated. */
	private static final class Row {

		private final int width;
		/** Of the pixels above and below each: the larger, the smaller. */
		private final float[] larger, smaller;
		/** Of each column of three: the largest, the smallest, the middle one; a column more at both sides. */
		private final float[] most, least, middle;

		Row(final int width) {
			this.width = width;
			larger = new float[width];
			smaller = new float[width];
			most = new float[width + 2];
			least = new float[width + 2];
			middle = new float[width + 2];
		}

		void clip(final float[] in, final int up, final int here, final int down,
			final float[] out) {
			for (int x = 0; x < width; x++) {
				larger[x] = Math.max(in[up + x], in[down + x]);
				smaller[x] = Math.min(in[up + x], in[down + x]);
			}
			for (int x = 0; x < width; x++) {
				final float value = in[here + x];
				most[x + 1] = Math.max(larger[x], value);
				least[x + 1] = Math.min(smaller[x], value);
				middle[x + 1] = Math.max(smaller[x], Math.min(larger[x], value));
			}
			for (final float[] columns : new float[][]{most, least, middle}) {
				columns[0] = columns[1];
				columns[width + 1] = columns[width];
			}
			for (int x = 0; x < width; x++)
				out[here + x] = Math.max(secondSmallest(x),
					Math.min(secondLargest(x), in[here + x]));
		}

		/** Of the eight neighbours. */
		private float secondLargest(final int x) {
			final float sides = Math.max(most[x], most[x + 2]);
			final float second = Math.max(Math.min(most[x], most[x + 2]),
				Math.max(middle[x], middle[x + 2]));
			return Math.max(Math.min(sides, larger[x]), Math.max(second, smaller[x]));
		}

		private float secondSmallest(final int x) {
			final float sides = Math.min(least[x], least[x + 2]);
			final float second = Math.min(Math.max(least[x], least[x + 2]),
				Math.min(middle[x], middle[x + 2]));
			return Math.min(Math.max(sides, smaller[x]), Math.min(second, larger[x]));
		}
	}
}
