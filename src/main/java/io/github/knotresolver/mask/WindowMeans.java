package io.github.knotresolver.mask;

/**
 * Mean intensities of one region of a frame, over all of it and over square
 * windows, from summed-area tables.
 */
final class WindowMeans {

	private final int width;
	private final int height;
	/** Sum and number of the region's pixels above and left of a corner. */
	private final double[] sums;
	private final int[] counts;

	WindowMeans(final float[] values, final boolean[] mask, final boolean wanted, final int width) {
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
