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

	/**
	 * Works on copies of rows, without branches: only of arrays that all are read at the same index
	 * does Java's compiler look at several pixels at a time. Beyond the border its pixels are repeated.
	 */
	private static final class Row {

		private final int width;
		/** The pixels above, the row itself, and those below. */
		private final float[] up, here, down;
		/** Of the pixels above and below each: the larger, the smaller. */
		private final float[] larger, smaller;
		/** Of each column of three: the largest, the smallest, the middle one. */
		private final float[] most, least, middle;
		/** Of a column's two neighbours: on the left, on the right. */
		private final float[] left, right;
		/** What each pixel is held between. */
		private final float[] low, high;

		Row(final int width) {
			this.width = width;
			up = new float[width];
			here = new float[width];
			down = new float[width];
			larger = new float[width];
			smaller = new float[width];
			most = new float[width];
			least = new float[width];
			middle = new float[width];
			left = new float[width];
			right = new float[width];
			low = new float[width];
			high = new float[width];
		}

		void clip(final float[] in, final int above, final int row, final int below,
			final float[] out) {
			System.arraycopy(in, above, up, 0, width);
			System.arraycopy(in, row, here, 0, width);
			System.arraycopy(in, below, down, 0, width);
			for (int x = 0; x < up.length; x++) {
				larger[x] = Math.max(up[x], down[x]);
				smaller[x] = Math.min(up[x], down[x]);
			}
			for (int x = 0; x < here.length; x++) {
				most[x] = Math.max(larger[x], here[x]);
				least[x] = Math.min(smaller[x], here[x]);
				middle[x] = Math.max(smaller[x], Math.min(larger[x], here[x]));
			}
			secondLargest();
			secondSmallest();
			for (int x = 0; x < here.length; x++)
				here[x] = Math.max(low[x], Math.min(high[x], here[x]));
			System.arraycopy(here, 0, out, row, width);
		}

		/** Of the eight neighbours. */
		private void secondLargest() {
			beside(most);
			for (int x = 0; x < high.length; x++)
				high[x] = Math.max(Math.min(left[x], right[x]),
					Math.min(Math.max(left[x], right[x]), larger[x]));
			beside(middle);
			for (int x = 0; x < high.length; x++)
				high[x] = Math.max(Math.max(high[x], smaller[x]), Math.max(left[x], right[x]));
		}

		private void secondSmallest() {
			beside(least);
			for (int x = 0; x < low.length; x++)
				low[x] = Math.min(Math.max(left[x], right[x]),
					Math.max(Math.min(left[x], right[x]), smaller[x]));
			beside(middle);
			for (int x = 0; x < low.length; x++)
				low[x] = Math.min(Math.min(low[x], larger[x]), Math.min(left[x], right[x]));
		}

		private void beside(final float[] columns) {
			System.arraycopy(columns, 0, left, 1, width - 1);
			left[0] = columns[0];
			System.arraycopy(columns, 1, right, 0, width - 1);
			right[width - 1] = columns[width - 1];
		}
	}
}
