package io.github.knotresolver.image;

import java.util.Arrays;

import net.imglib2.Cursor;
import net.imglib2.type.numeric.RealType;
import net.imglib2.view.Views;

import io.github.knotresolver.model.Movie;

/**
 * The intensities shown as black and as white, the same for all frames of a
 * movie.
 *
 * @param low shown as black
 * @param high shown as the brightest grey
 * @param brightest that grey, 1..255; less than white lets colours stand out
 */
public record Contrast(double low, double high, int brightest) {

	private static final double LOWEST = 0.01, HIGHEST = 0.998;
	/** So many pixels tell the percentiles well enough. */
	private static final int SAMPLE = 200_000;

	/**
	 * @param movie a movie
	 * @param brightest the brightest grey, 1..255
	 * @return its range of intensities without the extremes
	 */
	public static Contrast of(final Movie movie, final int brightest) {
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
			return new Contrast(0, 1, brightest);
		final double low = sample[(int) (LOWEST * (n - 1))],
			high = sample[(int) (HIGHEST * (n - 1))];
		return new Contrast(low, high > low ? high : low + 1, brightest);
	}

	/**
	 * @param value an intensity
	 * @return how it is shown, 0 to the brightest grey
	 */
	public int gray(final double value) {
		return (int) Math.rint(brightest * Math.min(1, Math.max(0, (value - low) / (high - low))));
	}
}
