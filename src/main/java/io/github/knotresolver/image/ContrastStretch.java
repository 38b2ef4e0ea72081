
package io.github.knotresolver.image;

import java.util.Arrays;

import net.imglib2.RandomAccessibleInterval;
import net.imglib2.img.Img;
import net.imglib2.type.numeric.RealType;
import net.imglib2.type.numeric.real.FloatType;

/** Makes frames of any bit depth and exposure alike. */
public final class ContrastStretch {

	private ContrastStretch() {
	}

	/**
	 * Saturates the darkest and the brightest pixels and rescales the rest
	 * linearly to 0..1. Percentiles are interpolated linearly between the sorted
	 * values of all pixels that have one. If they coincide although the frame is
	 * not constant (a filament smaller than the saturated part on an empty
	 * background), the range from the lowest to the highest value is used. A
	 * constant frame becomes all 0, and so does a pixel without a value (NaN).
	 * O(n log n) for n pixels.
	 *
	 * @implNote op names="knotresolver.stretch"
	 * @param frame any two-dimensional image
	 * @param lowPercent how many percent of the pixels become 0, 0..100
	 * @param highPercent how many percent of the pixels become 1, 0..100; the sum
	 *          of both is below 100
	 * @return a new image of the same size, 0..1
	 */
	public static Img<FloatType> saturate(
		final RandomAccessibleInterval<? extends RealType<?>> frame, final double lowPercent,
		final double highPercent) {
		if (!(lowPercent >= 0 && highPercent >= 0 && lowPercent + highPercent < 100))
			throw new IllegalArgumentException(
				"The saturated percentages must not be negative and must add up to less than 100, but are "
					+ lowPercent + " and " + highPercent + ".");
		final double[] values = Pixels.doubles(frame);
		final double[] sorted = Arrays.stream(values).filter(Double::isFinite).sorted().toArray();
		final float[] stretched = new float[values.length];
		if (sorted.length > 0) {
			final double low = percentile(sorted, lowPercent);
			final double high = percentile(sorted, 100 - highPercent);
			if (low < high)
				rescale(values, low, high, stretched);
			else
				rescale(values, sorted[0], sorted[sorted.length - 1], stretched);
		}
		return Pixels.image(stretched, Pixels.width(frame));
	}

	private static double percentile(final double[] sorted, final double percent) {
		final double rank = percent / 100 * (sorted.length - 1);
		final int below = (int) rank;
		if (below + 1 >= sorted.length)
			return sorted[sorted.length - 1];
		final double step = sorted[below + 1] - sorted[below];
		return sorted[below] + (rank - below) * step;
	}

	private static void rescale(final double[] values, final double low, final double high,
		final float[] stretched) {
		if (!(low < high))
			return;
		final double scale = 1 / (high - low);
		for (int i = 0; i < values.length; i++)
			if (values[i] > low)
				stretched[i] = (float) Math.min(1, (values[i] - low) * scale);
	}
}
