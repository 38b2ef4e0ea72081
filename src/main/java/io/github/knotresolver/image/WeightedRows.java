package io.github.knotresolver.image;

import java.util.Arrays;

/**
 * Weighted sums of rows. Each row is copied before it is added: only arrays that are all read at
 * the same index does Java's compiler add several values at a time, which is worth far more than the
 * copy.
 */
final class WeightedRows {

	/** So many are added before a sum is stored. */
	private static final int TOGETHER = 4;

	private final int width;
	private final float[][] rows;

	/** @param width number of values in a row */
	WeightedRows(final int width) {
		this.width = width;
		rows = new float[TOGETHER][width];
	}

	/**
	 * Sums of parts of an array, added in the order given.
	 *
	 * @param in values
	 * @param from where each part begins
	 * @param factors one for each part
	 * @param sums the result, a row
	 */
	void sum(final float[] in, final int[] from, final float[] factors, final float[] sums) {
		Arrays.fill(sums, 0);
		for (int k = 0; k < from.length; k += TOGETHER) {
			final int count = Math.min(TOGETHER, from.length - k);
			for (int i = 0; i < count; i++)
				System.arraycopy(in, from[k + i], rows[i], 0, width);
			if (count == TOGETHER)
				addFour(factors, k, sums);
			else
				for (int i = 0; i < count; i++)
					add(rows[i], factors[k + i], sums);
		}
	}

	private void addFour(final float[] factors, final int first, final float[] sums) {
		final float[] a = rows[0], b = rows[1], c = rows[2], d = rows[3];
		final float fa = factors[first], fb = factors[first + 1], fc = factors[first + 2],
			fd = factors[first + 3];
		for (int x = 0; x < sums.length; x++)
			sums[x] = sums[x] + fa * a[x] + fb * b[x] + fc * c[x] + fd * d[x];
	}

	private static void add(final float[] row, final float factor, final float[] sums) {
		for (int x = 0; x < sums.length; x++)
			sums[x] = sums[x] + factor * row[x];
	}
}
