package io.github.knotresolver.image;

import java.util.Arrays;

/**
 * Whether a picture was blown up: then its pixels come in blocks, or neighbours share
 * their noise.
 *
 * @param factor edge of the blocks in pixels; 1 if there are none
 * @param smooth whether neighbouring pixels are far more alike than pixels three apart
 */
public record Enlargement(int factor, boolean smooth) {

	/**
	 * @param pixels a frame as it comes, row by row
	 * @param width of a row
	 * @return how it was enlarged, as far as can be seen; O(n)
	 */
	public static Enlargement of(final float[] pixels, final int width) {
		for (int factor = ImageTuning.LARGEST_BLOCK; factor > 1; factor--)
			if (width >= 4 * factor && isOfBlocks(pixels, width, factor))
				return new Enlargement(factor, false);
		final double apart = difference(pixels, width, ImageTuning.APART);
		return new Enlargement(1,
			apart > 0 && difference(pixels, width, 1) < ImageTuning.SMOOTHED * apart);
	}

	/** @return whether it was enlarged at all */
	public boolean isEnlarged() {
		return factor > 1 || smooth;
	}

	private static boolean isOfBlocks(final float[] pixels, final int width, final int factor) {
		int within = 0, alike = 0, between = 0, different = 0;
		for (int i = 1; i < pixels.length; i++) {
			final int x = i % width;
			if (x == 0)
				continue;
			final boolean same = pixels[i] == pixels[i - 1];
			if (x % factor == 0) {
				between++;
				different += same ? 0 : 1;
			} else {
				within++;
				alike += same ? 1 : 0;
			}
		}
		return alike > ImageTuning.ALIKE_IN_BLOCKS * within
			&& different > (1 - ImageTuning.ALIKE_IN_BLOCKS) * between
			&& different > within - alike;
	}

	/** The median difference of pixels in a row that are so far apart. */
	private static double difference(final float[] pixels, final int width, final int apart) {
		final float[] off = new float[pixels.length];
		int count = 0;
		for (int i = apart; i < pixels.length; i++)
			if (i % width >= apart && Float.isFinite(pixels[i] - pixels[i - apart]))
				off[count++] = Math.abs(pixels[i] - pixels[i - apart]);
		Arrays.sort(off, 0, count);
		return count == 0 ? 0 : off[count / 2];
	}
}
