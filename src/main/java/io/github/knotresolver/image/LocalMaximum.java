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
		final RowMaximum larger = new RowMaximum(width);
		final float[] rows = in.clone();
		for (int y = 0; y < height; y++)
			for (int d = 1; d <= radius; d++) {
				final int row = y * width;
				larger.raise(rows, row, in, row + d, width - d);
				larger.raise(rows, row + d, in, row, width - d);
			}
		final float[] out = rows.clone();
		for (int d = 1; d <= Math.min(radius, height - 1); d++) {
			larger.raise(out, 0, rows, d * width, (height - d) * width);
			larger.raise(out, d * width, rows, 0, (height - d) * width);
		}
		return out;
	}
}
