
package io.github.knotresolver.mask;

import net.imglib2.RandomAccessibleInterval;
import net.imglib2.type.numeric.real.FloatType;

import io.github.knotresolver.image.Pixels;

/** The published choice: in each frame the intensity that parts it best into dark and bright. */
public final class OtsuThreshold implements Thresholder {

	private static final int BINS = 256;

	@Override
	public Seed seed(final RandomAccessibleInterval<FloatType> frame) {
		return new Seed(frame, FixedThreshold.above(frame, of(frame)));
	}

	/**
	 * Otsu's method: the threshold with the greatest variance between the two
	 * classes, from a histogram of 256 bins on 0..1. If several are equally good
	 * (empty bins between two peaks) it is the middle one. Values outside 0..1
	 * count as 0 or 1, pixels without a value (NaN) as the lowest. O(n).
	 * <p>
	 * Otsu 1979, doi:10.1109/TSMC.1979.4310076.
	 *
	 * @implNote op names="knotresolver.otsu"
	 * @param frame a frame, 0..1
	 * @return the threshold, 0..1; 1 if all pixels are alike, so that none is
	 *         above it
	 */
	public static double of(final RandomAccessibleInterval<FloatType> frame) {
		return of(histogram(Pixels.floats(frame)));
	}

	private static long[] histogram(final float[] values) {
		final long[] histogram = new long[BINS];
		for (final float value : values)
			histogram[Math.round(Math.min(1, Math.max(0, value)) * (BINS - 1))]++;
		return histogram;
	}

	private static double of(final long[] histogram) {
		long total = 0;
		long moment = 0;
		for (int bin = 0; bin < BINS; bin++) {
			total += histogram[bin];
			moment += bin * histogram[bin];
		}
		double best = 0;
		double sumOfBest = 0;
		int countOfBest = 0;
		long dark = 0;
		long darkMoment = 0;
		for (int bin = 0; bin < BINS - 1; bin++) {
			dark += histogram[bin];
			darkMoment += bin * histogram[bin];
			final double variance = betweenClasses(dark, darkMoment, total, moment);
			if (variance > best) {
				best = variance;
				sumOfBest = 0;
				countOfBest = 0;
			}
			if (variance == best && best > 0) {
				sumOfBest += bin + 0.5;
				countOfBest++;
			}
		}
		return countOfBest == 0 ? 1 : sumOfBest / countOfBest / (BINS - 1);
	}

	private static double betweenClasses(final long dark, final long darkMoment, final long total,
		final long moment) {
		final long bright = total - dark;
		if (dark == 0 || bright == 0)
			return 0;
		final double difference = darkMoment / (double) dark
			- (moment - darkMoment) / (double) bright;
		return dark * (double) bright * difference * difference;
	}
}
