package io.github.knotresolver.mask;

import net.imglib2.RandomAccessibleInterval;
import net.imglib2.img.Img;
import net.imglib2.type.logic.BitType;
import net.imglib2.type.numeric.real.FloatType;

import io.github.knotresolver.image.Pixels;

/** Makes a dim end as bright as the rest, and the glow in a loop dark. */
public final class LocalContrast {

	private LocalContrast() {
	}

	/**
	 * Rescales each pixel so that 0 is what the background and 1 what the filament
	 * is like near it. Both are means over a square window, taken over the pixels
	 * outside and inside a first mask. They may only lie between the means of the
	 * whole frame: a dim part of the filament lowers the 1 and a glowing background
	 * raises the 0, but a bright crossing does not make the single strands beside
	 * it look dim, and empty background does not make noise look bright. Where the
	 * two come close to each other, the frame's means are used. A mask that is
	 * empty or full, or not brighter than the rest, gives all 0.
	 * <p>
	 * Local means instead of global ones for region-based contours: Lankton and
	 * Tannenbaum 2008, doi:10.1109/TIP.2008.2004611. By summed-area tables, O(n)
	 * for any radius.
	 *
	 * @implNote op names="knotresolver.localContrast"
	 * @param frame a clean frame
	 * @param mask a first mask of the same size, such as that of Otsu
	 * @param radius half the edge of the window in pixels, at least 1
	 * @return a new image of the same size, 0..1
	 */
	public static Img<FloatType> normalize(final RandomAccessibleInterval<FloatType> frame,
		final RandomAccessibleInterval<BitType> mask, final int radius) {
		if (radius < 1)
			throw new IllegalArgumentException(
				"The radius of the window must be at least 1 pixel, but is " + radius + ".");
		Masks.requireSameSize(frame, mask);
		final float[] values = Pixels.floats(frame);
		final boolean[] inside = Pixels.bits(mask);
		final int width = Pixels.width(frame);
		final WindowMeans bright = new WindowMeans(values, inside, true, width);
		final WindowMeans dark = new WindowMeans(values, inside, false, width);
		final double least = MaskTuning.LEAST_CONTRAST * (bright.all() - dark.all());
		final float[] normalized = new float[values.length];
		for (int at = 0; at < values.length; at++) {
			final double high = lower(bright.all(), bright.around(at, radius));
			final double low = higher(dark.all(), dark.around(at, radius));
			normalized[at] = high - low > least
				? between(low, high, values[at])
				: between(dark.all(), bright.all(), values[at]);
		}
		return Pixels.image(normalized, width);
	}

	/** @return the value's place from low to high, 0..1; 0 if there is none */
	private static float between(final double low, final double high, final double value) {
		return high > low ? (float) Math.max(0, Math.min(1, (value - low) / (high - low))) : 0;
	}

	private static double lower(final double global, final double local) {
		return local < global ? local : global;
	}

	private static double higher(final double global, final double local) {
		return local > global ? local : global;
	}

	/**
	 * Mean intensities of one region of a frame, over all of it and over square
	 * windows, from summed-area tables.
	 */
	private static final class WindowMeans {

		private final int width;
		private final int height;
		/** Sum and number of the region's pixels above and left of a corner. */
		private final double[] sums;
		private final int[] counts;

		WindowMeans(final float[] values, final boolean[] mask, final boolean wanted,
			final int width) {
			this.width = width;
			this.height = values.length / width;
			sums = new double[(width + 1) * (height + 1)];
			counts = new int[sums.length];
			for (int y = 0, at = 0; y < height; y++) {
				double sum = 0;
				int count = 0;
				for (int x = 0; x < width; x++, at++) {
					if (mask[at] == wanted) {
						sum += values[at];
						count++;
					}
					final int corner = (y + 1) * (width + 1) + x + 1;
					sums[corner] = sums[corner - width - 1] + sum;
					counts[corner] = counts[corner - width - 1] + count;
				}
			}
		}

		/** @return the mean of the whole region; NaN if it is empty */
		double all() {
			return mean(0, 0, width, height);
		}

		/** @return the mean of the region near a pixel; NaN if there is none of it */
		double around(final int at, final int radius) {
			final int x = at % width;
			final int y = at / width;
			return mean(Math.max(0, x - radius), Math.max(0, y - radius),
				Math.min(width, x + radius + 1), Math.min(height, y + radius + 1));
		}

		private double mean(final int left, final int top, final int right, final int bottom) {
			final int upper = top * (width + 1);
			final int lower = bottom * (width + 1);
			final int count = counts[lower + right] - counts[lower + left] - counts[upper + right]
				+ counts[upper + left];
			final double sum = sums[lower + right] - sums[lower + left] - sums[upper + right]
				+ sums[upper + left];
			return sum / count;
		}
	}
}
