package io.github.knotresolver.measure;

import org.apache.commons.math3.transform.DftNormalization;
import org.apache.commons.math3.transform.FastFourierTransformer;
import org.apache.commons.math3.transform.TransformType;

import io.github.knotresolver.progress.Cancellation;

/**
 * Sums of values times cosine and sine at all frequencies of a grid: the discrete Fourier transform of
 * any length, by Bluestein's convolution with a chirp (1970, doi:10.1109/TAU.1970.1162132). Angles are
 * reduced to one turn in whole numbers, so the error stays that of the arithmetic however long the
 * series. O((values + frequencies) log(values + frequencies)) in time, linear in memory; may be used by
 * several threads.
 */
final class ChirpTransform {

	private final int values, frequencies;
	private final long cycle, first, harmonic;
	/** Transform of the conjugate chirp, real and imaginary part. */
	private final double[][] kernel;

	/**
	 * @param values how many there are in a series, one a frame
	 * @param grid the frequencies
	 * @param harmonic these times the frequencies are taken, from 1
	 */
	ChirpTransform(final int values, final FrequencyGrid grid, final int harmonic) {
		this.values = values;
		this.frequencies = grid.size();
		this.cycle = grid.cycle();
		this.first = grid.first();
		this.harmonic = harmonic;
		final int length = Math.max(2, Integer.highestOneBit(values + frequencies - 1) * 2);
		kernel = new double[2][length];
		for (int m = 1 - values; m < frequencies; m++) {
			final int at = m < 0 ? m + length : m;
			kernel[0][at] = Math.cos(chirp(m));
			kernel[1][at] = -Math.sin(chirp(m));
		}
		transform(kernel, TransformType.FORWARD);
	}

	/** Angle of -harmonic m²/2 cycles. */
	private double chirp(final long m) {
		return -Math.PI * (harmonic * m * m % (2 * cycle)) / cycle;
	}

	/** Angle by which value j is turned, so that the first frequency becomes the zeroth. */
	private double start(final long j) {
		return -2 * Math.PI * (harmonic * first * j % cycle) / cycle;
	}

	/**
	 * @param series one value a frame; 0 where it is missing
	 * @return sums of value times cosine, and of value times sine, for each frequency; the phase counts
	 *         from the first value
	 */
	double[][] sums(final double[] series) {
		final double[][] z = new double[2][kernel[0].length];
		for (int j = 0; j < values; j++) {
			final double angle = start(j) + chirp(j);
			z[0][j] = series[j] * Math.cos(angle);
			z[1][j] = series[j] * Math.sin(angle);
		}
		transform(z, TransformType.FORWARD);
		for (int i = 0; i < z[0].length; i++) {
			final double re = z[0][i] * kernel[0][i] - z[1][i] * kernel[1][i];
			z[1][i] = z[0][i] * kernel[1][i] + z[1][i] * kernel[0][i];
			z[0][i] = re;
		}
		transform(z, TransformType.INVERSE);
		final double[][] sums = new double[2][frequencies];
		for (int k = 0; k < frequencies; k++) {
			final double c = Math.cos(chirp(k)), s = Math.sin(chirp(k));
			sums[0][k] = z[0][k] * c - z[1][k] * s;
			sums[1][k] = -(z[0][k] * s + z[1][k] * c);
		}
		return sums;
	}

	private static void transform(final double[][] z, final TransformType type) {
		Cancellation.check();
		FastFourierTransformer.transformInPlace(z, DftNormalization.STANDARD, type);
	}
}
