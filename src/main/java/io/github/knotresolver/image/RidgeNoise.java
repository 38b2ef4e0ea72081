package io.github.knotresolver.image;

import java.util.Arrays;

/**
 * The noise of a filter's response, from place to place: in tiles, from a low quantile
 * of its magnitude, which filaments hardly touch since they cover less than the rest;
 * interpolated between the tiles' centres.
 */
final class RidgeNoise {

	/** Edge of a tile in pixels, about. */
	private static final int TILE = 48;

	/** Every third pixel along both axes is looked at. */
	static final int STRIDE = 3;

	/** This quantile of the magnitudes, and what it is for a standard deviation of 1. */
	private static final double QUANTILE = 0.4, NORMAL = 0.5244;

	/** A tile's noise is held within this factor of the middle one. */
	private static final double FACTOR = 3;

	/** The noise is at least this part of the largest response: a movie may have none. */
	private static final double LEAST = 1e-3;

	private final int width, height, columns, rows;
	private final float[][] samples;
	private final int[] counts;
	private float largest;

	RidgeNoise(final int width, final int height) {
		this.width = width;
		this.height = height;
		columns = (int) Math.max(1, Math.round((double) width / TILE));
		rows = (int) Math.max(1, Math.round((double) height / TILE));
		samples = new float[columns * rows][256];
		counts = new int[columns * rows];
	}

	/** Takes every third response of a row. */
	void add(final int y, final float[] response, final int from) {
		final int row = y * rows / height;
		for (int x = 0; x < width; x += STRIDE)
			add(row * columns + x * columns / width, Math.abs(response[from + x]));
	}

	private void add(final int tile, final float magnitude) {
		if (counts[tile] == samples[tile].length)
			samples[tile] = Arrays.copyOf(samples[tile], 2 * counts[tile]);
		samples[tile][counts[tile]++] = magnitude;
		largest = Math.max(largest, magnitude);
	}

	/** @return the standard deviation at every pixel, above 0 */
	float[] field() {
		final double[] tiles = new double[samples.length];
		for (int i = 0; i < tiles.length; i++)
			tiles[i] = quantile(samples[i], counts[i]) / NORMAL;
		final double[] calm = medians(tiles);
		final double[] sorted = tiles.clone();
		Arrays.sort(sorted);
		final double middle = sorted[sorted.length / 2];
		final double least = Math.max(middle / FACTOR, Math.max(LEAST * largest, 1e-9));
		final double most = Math.max(middle * FACTOR, least);
		for (int i = 0; i < calm.length; i++)
			calm[i] = Math.min(Math.max(calm[i], least), most);
		return interpolated(calm);
	}

	private static double quantile(final float[] values, final int count) {
		if (count == 0)
			return 0;
		Arrays.sort(values, 0, count);
		return values[(int) (QUANTILE * (count - 1))];
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
		for (int y = 0; y < height; y++) {
			final double v = Math.min(Math.max((y + 0.5) * rows / height - 0.5, 0), rows - 1);
			final int up = (int) v, down = Math.min(up + 1, rows - 1);
			for (int x = 0; x < width; x++) {
				final double u = Math.min(Math.max((x + 0.5) * columns / width - 0.5, 0),
					columns - 1);
				final int left = (int) u, right = Math.min(left + 1, columns - 1);
				final double above = mixed(tiles, up * columns + left, up * columns + right,
					u - left);
				final double below = mixed(tiles, down * columns + left, down * columns + right,
					u - left);
				field[y * width + x] = (float) (above + (v - up) * (below - above));
			}
		}
		return field;
	}

	private static double mixed(final double[] tiles, final int a, final int b,
		final double share) {
		return tiles[a] + share * (tiles[b] - tiles[a]);
	}
}
