package io.github.knotresolver.image;

import java.util.Arrays;

import io.github.knotresolver.geometry.RobustStatistics;

/**
 * The noise of a filter's response, from place to place: in tiles, from a low quantile
 * of its magnitude, which filaments hardly touch since they cover less than the rest;
 * interpolated between the tiles' centres.
 */
final class RidgeNoise {

	/** Every third pixel along both axes is looked at. */
	static final int STRIDE = 3;

	/** The quantile of the magnitudes that noise is measured from, if the standard deviation is 1. */
	private static final double NORMAL = 0.5244;

	private final int width, height, columns, rows;
	/** Magnitudes as the bits of their floats, which are in the same order. */
	private final int[][] samples;
	private final int[] counts;
	private float largest;

	RidgeNoise(final int width, final int height) {
		this.width = width;
		this.height = height;
		columns = (int) Math.max(1, Math.round((double) width / ImageTuning.NOISE_TILE));
		rows = (int) Math.max(1, Math.round((double) height / ImageTuning.NOISE_TILE));
		samples = new int[columns * rows][256];
		counts = new int[columns * rows];
	}

	/** Takes every third response of a row. */
	void add(final int y, final float[] response, final int from) {
		final int row = y * rows / height * columns;
		int x = 0;
		for (int column = 0; column < columns; column++) {
			// The first that belongs to the next tile.
			final int end = ((column + 1) * width + columns - 1) / columns;
			x = add(row + column, response, from, x, end);
		}
	}

	/** Every third response from a column to another; gives the next one's column. */
	private int add(final int tile, final float[] response, final int from, final int begin,
		final int end) {
		if (counts[tile] + (end - begin) / STRIDE + 1 > samples[tile].length)
			samples[tile] = Arrays.copyOf(samples[tile], 2 * samples[tile].length + end - begin);
		final int[] of = samples[tile];
		int count = counts[tile], x = begin;
		for (; x < end; x += STRIDE) {
			final float magnitude = Math.abs(response[from + x]);
			of[count++] = Float.floatToRawIntBits(magnitude);
			largest = Math.max(largest, magnitude);
		}
		counts[tile] = count;
		return x;
	}

	/** @return the standard deviation at every pixel, above 0 */
	float[] field() {
		final double[] tiles = new double[samples.length];
		for (int i = 0; i < tiles.length; i++)
			tiles[i] = quantile(samples[i], counts[i]) / NORMAL;
		final double[] calm = medians(tiles);
		final double middle = RobustStatistics.upperMedian(tiles, 0);
		final double least = Math.max(middle / ImageTuning.NOISE_FACTOR,
			Math.max(ImageTuning.LEAST_NOISE * largest, 1e-9));
		final double most = Math.max(middle * ImageTuning.NOISE_FACTOR, least);
		for (int i = 0; i < calm.length; i++)
			calm[i] = Math.min(Math.max(calm[i], least), most);
		return interpolated(calm);
	}

	private static double quantile(final int[] values, final int count) {
		return count == 0
			? 0
			: Float.intBitsToFloat(
				smallest(values, count, (int) (ImageTuning.NOISE_QUANTILE * (count - 1))));
	}

	/** The value that would be at a place if the first so many were sorted; O(count). Hoare 1961, doi:10.1145/366622.366647. */
	private static int smallest(final int[] values, final int count, final int place) {
		int low = 0, high = count - 1;
		while (low < high) {
			final int pivot = values[(low + high) >>> 1];
			int i = low, j = high;
			while (i <= j) {
				while (values[i] < pivot)
					i++;
				while (values[j] > pivot)
					j--;
				if (i <= j) {
					final int swap = values[i];
					values[i++] = values[j];
					values[j--] = swap;
				}
			}
			if (place <= j)
				high = j;
			else if (place >= i)
				low = i;
			else
				return values[place];
		}
		return values[place];
	}

	/** Medians of each tile and its neighbours: one that is full of filament does not count. */
	private double[] medians(final double[] tiles) {
		final double[] medians = new double[tiles.length];
		final double[] around = new double[9];
		for (int i = 0; i < tiles.length; i++) {
			for (int k = 0; k < 9; k++) {
				final int r = Math.min(Math.max(i / columns + k / 3 - 1, 0), rows - 1);
				final int c = Math.min(Math.max(i % columns + k % 3 - 1, 0), columns - 1);
				around[k] = tiles[r * columns + c];
			}
			Arrays.sort(around);
			medians[i] = around[4];
		}
		return medians;
	}

	private float[] interpolated(final double[] tiles) {
		final float[] field = new float[width * height];
		final double[] above = new double[width], below = new double[width];
		int drawn = -1;
		for (int y = 0; y < height; y++) {
			final double v = Math.min(Math.max((y + 0.5) * rows / height - 0.5, 0), rows - 1);
			final int up = (int) v;
			if (up != drawn) {
				alongRow(tiles, up, above);
				alongRow(tiles, Math.min(up + 1, rows - 1), below);
				drawn = up;
			}
			final double share = v - up;
			final int row = y * width;
			for (int x = 0; x < width; x++)
				field[row + x] = (float) (above[x] + share * (below[x] - above[x]));
		}
		return field;
	}

	/** A row of tiles, interpolated. */
	private void alongRow(final double[] tiles, final int row, final double[] out) {
		for (int x = 0; x < width; x++) {
			final double u = Math.min(Math.max((x + 0.5) * columns / width - 0.5, 0), columns - 1);
			final int left = (int) u, right = Math.min(left + 1, columns - 1);
			final double value = tiles[row * columns + left];
			out[x] = value + (u - left) * (tiles[row * columns + right] - value);
		}
	}
}
