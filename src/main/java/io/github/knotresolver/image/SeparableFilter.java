package io.github.knotresolver.image;

import java.util.Arrays;

/**
 * Filters along rows and columns; beyond the border the outermost pixels are
 * repeated.
 */
final class SeparableFilter {

	private SeparableFilter() {
	}

	/** @return a normalised Gaussian of {@code size} values, odd */
	static double[] gauss(final int size, final double sigma) {
		final double[] kernel = new double[size];
		double sum = 0;
		for (int i = 0; i < size; i++) {
			final double x = i - size / 2;
			kernel[i] = Math.exp(-x * x / (2 * sigma * sigma));
			sum += kernel[i];
		}
		for (int i = 0; i < size; i++)
			kernel[i] /= sum;
		return kernel;
	}

	/** @return rows filtered by a kernel of odd length */
	static float[] alongRows(final float[] in, final int width, final double[] kernel) {
		final int radius = kernel.length / 2;
		final float[] out = new float[in.length];
		final float[] padded = new float[width + 2 * radius];
		for (int row = 0; row < in.length; row += width) {
			pad(in, row, width, radius, padded, 0);
			for (int x = 0; x < width; x++) {
				double sum = 0;
				for (int k = 0; k < kernel.length; k++)
					sum += kernel[k] * padded[x + k];
				out[row + x] = (float) sum;
			}
		}
		return out;
	}

	/** As {@link #alongRows} with sums of single precision, a kernel's value at a time: several times faster. */
	static float[] rows(final float[] in, final int width, final double[] kernel) {
		final int radius = kernel.length / 2;
		final float[] out = new float[in.length];
		final float[] padded = new float[width + 2 * radius], sums = new float[width];
		final float[] factors = Pixels.floats(kernel);
		final int[] from = new int[kernel.length];
		Arrays.setAll(from, k -> k);
		final WeightedRows weighted = new WeightedRows(width);
		for (int row = 0; row < in.length; row += width) {
			pad(in, row, width, radius, padded, 0);
			weighted.sum(padded, from, factors, sums);
			System.arraycopy(sums, 0, out, row, width);
		}
		return out;
	}

	/** Columns filtered by a kernel of odd length, with sums of single precision. */
	static float[] columns(final float[] in, final int width, final double[] kernel) {
		final int radius = kernel.length / 2, height = in.length / width;
		final float[] out = new float[in.length];
		final float[] sums = new float[width], factors = Pixels.floats(kernel);
		final int[] from = new int[kernel.length];
		final WeightedRows weighted = new WeightedRows(width);
		for (int y = 0; y < height; y++) {
			for (int k = 0; k < from.length; k++)
				from[k] = Math.min(Math.max(y + k - radius, 0), height - 1) * width;
			weighted.sum(in, from, factors, sums);
			System.arraycopy(sums, 0, out, y * width, width);
		}
		return out;
	}

	/** A row with its outermost pixels repeated, put into an array at a place. */
	static void pad(final float[] in, final int row, final int width, final int radius,
		final float[] padded, final int to) {
		Arrays.fill(padded, to, to + radius, in[row]);
		System.arraycopy(in, row, padded, to + radius, width);
		Arrays.fill(padded, to + radius + width, to + width + 2 * radius, in[row + width - 1]);
	}

	/** @return rows as columns */
	static float[] transposed(final float[] in, final int width) {
		final int height = in.length / width;
		final float[] out = new float[in.length];
		for (int y = 0; y < height; y++)
			for (int x = 0; x < width; x++)
				out[x * height + y] = in[y * width + x];
		return out;
	}
}
