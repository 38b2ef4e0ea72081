package io.github.knotresolver.image;

/** The largest value nearby. */
final class LocalMaximum {

	private LocalMaximum() {
	}

	/**
	 * @param in pixels row by row
	 * @param width of a row
	 * @param radius at least 0
	 * @return for each pixel the largest in the square of {@code 2 radius + 1} around it
	 */
	static float[] of(final float[] in, final int width, final int radius) {
		final int height = in.length / width;
		final float[] rows = in.clone();
		for (int y = 0; y < height; y++)
			for (int d = 1; d <= radius; d++) {
				final int row = y * width;
				raise(rows, row, in, row + d, width - d);
				raise(rows, row + d, in, row, width - d);
			}
		final float[] out = rows.clone();
		for (int d = 1; d <= Math.min(radius, height - 1); d++) {
			raise(out, 0, rows, d * width, (height - d) * width);
			raise(out, d * width, rows, 0, (height - d) * width);
		}
		return out;
	}

	private static void raise(final float[] values, final int to, final float[] others,
		final int from, final int count) {
		for (int i = 0; i < count; i++)
			values[to + i] = Math.max(values[to + i], others[from + i]);
	}
}
