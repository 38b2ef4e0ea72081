package io.github.knotresolver.image;

import java.util.Arrays;

/** The 8-connected parts of thin lines that have many pixels. */
final class LongParts {

	private LongParts() {
	}

	/**
	 * @param bits row by row; emptied
	 * @param width of a row
	 * @param least number of pixels of a part
	 * @return the places of all pixels of parts that are large enough
	 */
	static int[] of(final boolean[] bits, final int width, final double least) {
		final int[] places = new int[bits.length];
		int kept = 0;
		for (int start = 0; start < bits.length; start++)
			if (bits[start]) {
				final int end = fill(bits, width, start, places, kept);
				if (end - kept >= least)
					kept = end;
			}
		return Arrays.copyOf(places, kept);
	}

	private static int fill(final boolean[] bits, final int width, final int start,
		final int[] places, final int from) {
		final int height = bits.length / width;
		int count = from;
		bits[start] = false;
		places[count++] = start;
		for (int i = from; i < count; i++) {
			final int x = places[i] % width, y = places[i] / width;
			for (int v = Math.max(0, y - 1); v <= Math.min(height - 1, y + 1); v++)
				for (int u = Math.max(0, x - 1); u <= Math.min(width - 1, x + 1); u++)
					if (bits[v * width + u]) {
						bits[v * width + u] = false;
						places[count++] = v * width + u;
					}
		}
		return count;
	}
}
