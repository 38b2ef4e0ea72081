package io.github.knotresolver.image;

import org.apache.commons.math3.stat.descriptive.rank.Median;

import io.github.knotresolver.geometry.RobustStatistics;

/** How noisy a frame is. */
public final class PixelNoise {

	private PixelNoise() {
	}

	/**
	 * The noise of single pixels, from the differences of neighbours in a row: a few
	 * lines and an uneven background hardly matter. Pixels without a value (NaN) do
	 * not count. O(n) for n pixels.
	 *
	 * @param pixels row by row
	 * @param width in pixels
	 * @return its standard deviation; 0 if there are no neighbours
	 */
	public static double of(final double[] pixels, final int width) {
		final double[] off = new double[pixels.length];
		int count = 0;
		for (int i = 1; i < pixels.length; i++)
			if (i % width != 0 && Double.isFinite(pixels[i] - pixels[i - 1]))
				off[count++] = Math.abs(pixels[i] - pixels[i - 1]);
		return count == 0
			? 0
			: RobustStatistics.MAD_TO_SD * new Median().evaluate(off, 0, count) / Math.sqrt(2);
	}
}
