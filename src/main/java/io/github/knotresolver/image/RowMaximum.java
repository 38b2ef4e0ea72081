package io.github.knotresolver.image;

/**
 * The larger of two rows, value by value. Works on copies: only of arrays that all are read at the
 * same index does Java's compiler compare several values at a time.
 */
final class RowMaximum {

	private final int width;
	private final float[] row, other;

	/** @param width number of values in a row */
	RowMaximum(final int width) {
		this.width = width;
		row = new float[width];
		other = new float[width];
	}

	/**
	 * Raises values to others.
	 *
	 * @param values to be raised
	 * @param to index of the first
	 * @param others what they are raised to
	 * @param from index of the first
	 * @param count how many; may be more than a row
	 */
	void raise(final float[] values, final int to, final float[] others, final int from,
		final int count) {
		for (int begin = 0; begin < count; begin += width) {
			final int length = Math.min(width, count - begin);
			System.arraycopy(values, to + begin, row, 0, length);
			System.arraycopy(others, from + begin, other, 0, length);
			for (int x = 0; x < length; x++)
				row[x] = Math.max(row[x], other[x]);
			System.arraycopy(row, 0, values, to + begin, length);
		}
	}
}
