package io.github.knotresolver.image;

import org.apache.commons.math3.linear.Array2DRowRealMatrix;
import org.apache.commons.math3.linear.ArrayRealVector;
import org.apache.commons.math3.linear.CholeskyDecomposition;
import org.apache.commons.math3.linear.NonPositiveDefiniteMatrixException;

/**
 * What the background does over the whole frame, as uneven illumination makes it: a plane and a
 * bow. A local mean is that of the pixels that are background, and where these lie on one side
 * only, at the border or beside a line, the trend makes it wrong.
 */
final class BackgroundTrend {

	/** Of 1, x, y, x², xy and y², across the frame from -1 to 1. */
	private static final int TERMS = 6;

	/** About so many pixels are looked at. */
	private static final int MOST_PIXELS = 1 << 16;

	/** No trend. */
	private static final BackgroundTrend NONE = new BackgroundTrend(0, 0, new double[TERMS]);

	private final int width, height;
	private final double[] factors;

	private BackgroundTrend(final int width, final int height, final double[] factors) {
		this.width = width;
		this.height = height;
		this.factors = factors;
	}

	/**
	 * By least squares over a grid of pixels. O(n) for n pixels.
	 *
	 * @param pixels row by row
	 * @param width of a row
	 * @param out what is not background, row by row
	 * @return the trend; none if it is less than the noise
	 */
	static BackgroundTrend of(final float[] pixels, final int width, final boolean[] out) {
		final int height = pixels.length / width;
		final int step = (int) Math.ceil(Math.sqrt((double) pixels.length / MOST_PIXELS));
		final double[][] matrix = new double[TERMS][TERMS];
		final double[] right = new double[TERMS], terms = new double[TERMS];
		double steps = 0, pairs = 0;
		for (int y = 0; y < height; y += step)
			for (int x = 0; x < width; x += step) {
				final int i = y * width + x;
				if (out[i])
					continue;
				terms(terms, x, y, width, height);
				for (int k = 0; k < TERMS; k++) {
					right[k] += terms[k] * pixels[i];
					for (int m = 0; m < TERMS; m++)
						matrix[k][m] += terms[k] * terms[m];
				}
				if (x > 0 && !out[i - 1]) {
					steps += (pixels[i] - pixels[i - 1]) * (pixels[i] - pixels[i - 1]);
					pairs++;
				}
			}
		try {
			final double[] factors = new CholeskyDecomposition(
				new Array2DRowRealMatrix(matrix, false)).getSolver()
				.solve(new ArrayRealVector(right, false)).toArray();
			final BackgroundTrend trend = new BackgroundTrend(width, height, factors);
			return trend.range() > Math.sqrt(steps / pairs / 2) ? trend : NONE;
		} catch (final NonPositiveDefiniteMatrixException e) {
			// Too few pixels are background, or all of them lie on a line.
			return NONE;
		}
	}

	private static void terms(final double[] terms, final double x, final double y, final int width,
		final int height) {
		final double u = across(x, width), v = across(y, height);
		terms[0] = 1;
		terms[1] = u;
		terms[2] = v;
		terms[3] = u * u;
		terms[4] = u * v;
		terms[5] = v * v;
	}

	/** From -1 to 1. */
	private static double across(final double at, final int size) {
		return size > 1 ? 2 * at / (size - 1) - 1 : 0;
	}

	/** By how much it differs between the corners, the middles of the sides and the centre. */
	private double range() {
		double least = Double.POSITIVE_INFINITY, most = Double.NEGATIVE_INFINITY;
		for (int k = 0; k < 9; k++) {
			final double at = at(k % 3 * (width - 1) / 2.0, k / 3 * (height - 1) / 2.0);
			least = Math.min(least, at);
			most = Math.max(most, at);
		}
		return most - least;
	}

	private double at(final double x, final double y) {
		final double u = across(x, width), v = across(y, height);
		return factors[0] + v * (factors[2] + v * factors[5])
			+ u * (factors[1] + v * factors[4] + u * factors[3]);
	}

	/** @return the trend, row by row */
	float[] values() {
		final float[] values = new float[width * height];
		for (int i = 0; i < values.length; i++)
			values[i] = (float) at(i % width, i / width);
		return values;
	}

	/** @return whether there is one */
	boolean isThere() {
		return this != NONE;
	}
}
