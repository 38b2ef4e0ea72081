package io.github.knotresolver.imagej;

import java.util.Arrays;

import net.imglib2.Cursor;
import net.imglib2.type.numeric.RealType;
import net.imglib2.view.Views;

import io.github.knotresolver.image.Movie;

/**
 * The intensities shown as black and as white, the same for all frames of a
 * movie.
 *
 * @param low shown as black
 * @param high shown as white
 */
record Contrast(double low, double high) {

	private static final double DARKEST = 0.01, BRIGHTEST = 0.998;
	/** So many pixels tell the percentiles well enough. */
	private static final int SAMPLE = 200_000;

	/**
	 * @param movie a movie
	 * @return its range of intensities without the extremes
	 */
	static Contrast of(final Movie movie) {
		final long pixels = (long) movie.width() * movie.height() * movie.size();
		final int step = (int) Math.max(1, pixels / SAMPLE);
		final double[] sample = new double[(int) (pixels / step)];
		final Cursor<? extends RealType<?>> cursor = Views.flatIterable(movie.frames()).cursor();
		int n = 0;
		for (int i = 0; i < sample.length; i++) {
			cursor.jumpFwd(step);
			final double value = cursor.get().getRealDouble();
			if (Double.isFinite(value))
				sample[n++] = value;
		}
		Arrays.sort(sample, 0, n);
		if (n == 0)
			return new Contrast(0, 1);
		final double low = sample[(int) (DARKEST * (n - 1))],
			high = sample[(int) (BRIGHTEST * (n - 1))];
		return new Contrast(low, high > low ? high : low + 1);
	}

	/**
	 * @param value an intensity
	 * @return how it is shown, 0..255
	 */
	int gray(final double value) {
		return (int) Math.rint(255 * Math.min(1, Math.max(0, (value - low) / (high - low))));
	}
}
