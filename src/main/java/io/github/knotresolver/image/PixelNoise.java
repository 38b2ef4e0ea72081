package io.github.knotresolver.image;

import org.apache.commons.math3.stat.descriptive.rank.Median;

import io.github.knotresolver.geometry.RobustStatistics;

/** How noisy a frame is. */
public final class PixelNoise {

	private PixelNoise() {
	}

	/**
	 * The noise of single pixels, from the differences of neighbours in a row: a few
	 * lines and an uneven background hardly matter. Where neighbours share their noise, as in a
	 * picture that was enlarged or compressed, from those of pixels farther apart. Pixels without a
	 * value (NaN) do not count. O(n) for n pixels.
	 *
	 * @param pixels row by row
	 * @param width in pixels
	 * @return its standard deviation; 0 if there are no neighbours
	 */
	public static double of(final double[] pixels, final int width) {
		final double neighbours = ofDifferences(pixels, width, 1),
			apart = ofDifferences(pixels, width, ImageTuning.APART);
		return neighbours < ImageTuning.SMOOTHED * apart ? apart : neighbours;
	}

	private static double ofDifferences(final double[] pixels, final int width, final int apart) {
		final double[] off = new double[pixels.length];
		int count = 0;
		for (int i = apart; i < pixels.length; i++)
			if (i % width >= apart && Double.isFinite(pixels[i] - pixels[i - apart]))
				off[count++] = Math.abs(pixels[i] - pixels[i - apart]);
		return count == 0
			? 0
			: RobustStatistics.MAD_TO_SD * new Median().evaluate(off, 0, count) / Math.sqrt(2);
	}
}
