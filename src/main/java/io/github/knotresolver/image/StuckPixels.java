package io.github.knotresolver.image;

import java.util.Arrays;
import java.util.BitSet;
import java.util.function.IntToDoubleFunction;

import io.github.knotresolver.geometry.RobustStatistics;

/**
 * Pixels of a camera that are far too bright in all frames, "hot" ones. Their shape tells: light
 * that came through a lens reaches the neighbours, too, and these do not. At most one of a
 * pixel's neighbours may be another one.
 */
public final class StuckPixels {

	/** Of a surface that is smooth across a pixel: twice the mean of its sides, less that of its corners. */
	private static final double SIDE = 0.5, CORNER = -0.25;

	private static final int NEIGHBOURS = 8;

	private final int width, height;
	private final BitSet stuck;

	private StuckPixels(final int width, final int height, final BitSet stuck) {
		this.width = width;
		this.height = height;
		this.stuck = stuck;
	}

	/**
	 * O(pixels log pixels).
	 *
	 * @param still a picture of what stays where it is, lines bright, row by row
	 * @param width of a row
	 * @param least by so much at least they are brighter than their second brightest neighbour
	 * @return the pixels
	 */
	public static StuckPixels in(final float[] still, final int width, final double least) {
		final StuckPixels pixels = new StuckPixels(width, still.length / width,
			new BitSet(still.length));
		final double[] off = new double[still.length];
		for (int at = 0; at < off.length; at++)
			off[at] = still[at] - pixels.filled(at, i -> still[i]);
		final double noise = RobustStatistics.MAD_TO_SD
			* RobustStatistics.median(Arrays.stream(off).map(Math::abs).toArray());
		final BitSet found = new BitSet(still.length);
		for (int at = 0; at < off.length; at++)
			if (off[at] > ImageTuning.STUCK_NOISE * noise && pixels.isAlone(at, still, least))
				found.set(at);
		return new StuckPixels(width, pixels.height, found);
	}

	private boolean isAlone(final int at, final float[] still, final double least) {
		double first = Double.NEGATIVE_INFINITY, second = first, darkest = Double.POSITIVE_INFINITY;
		for (int k = 0; k <= NEIGHBOURS; k++) {
			final int i = neighbour(at, k);
			if (i < 0)
				continue;
			final double value = still[i];
			second = Math.max(second, Math.min(first, value));
			first = Math.max(first, value);
			darkest = Math.min(darkest, value);
		}
		final double above = still[at] - second;
		return above > least && above > ImageTuning.STUCK_ALONE * (second - darkest);
	}

	/** Of a square of three by three pixels, row by row; -1 for the middle, and beyond the border. */
	private int neighbour(final int at, final int k) {
		final int x = at % width + k % 3 - 1, y = at / width + k / 3 - 1;
		return k == NEIGHBOURS / 2 || x < 0 || x >= width || y < 0 || y >= height
			? -1
			: y * width + x;
	}

	/** @return how many there are */
	public int count() {
		return stuck.cardinality();
	}

	/**
	 * @param at index of a pixel
	 * @return whether it is one of them
	 */
	public boolean contains(final int at) {
		return stuck.get(at);
	}

	/**
	 * What a pixel is without its own value: of the smoothest surface through its eight
	 * neighbours, which a line of any direction lies in; the mean of those that are left if one of
	 * them is stuck, too, or beyond the border.
	 *
	 * @param at index of a pixel
	 * @param values of the pixels of a frame
	 * @return the pixel's
	 */
	public double filled(final int at, final IntToDoubleFunction values) {
		double sides = 0, corners = 0;
		int left = 0;
		for (int k = 0; k <= NEIGHBOURS; k++) {
			final int i = neighbour(at, k);
			if (i < 0 || stuck.get(i))
				continue;
			left++;
			if (k % 2 == 0)
				corners += values.applyAsDouble(i);
			else
				sides += values.applyAsDouble(i);
		}
		if (left == NEIGHBOURS)
			return SIDE * sides + CORNER * corners;
		return left == 0 ? values.applyAsDouble(at) : (sides + corners) / left;
	}

	/**
	 * @param frame pixels of a frame, row by row
	 * @return the same with all of them filled in; the frame itself if there are none
	 */
	public float[] filled(final float[] frame) {
		if (stuck.isEmpty())
			return frame;
		final float[] filled = frame.clone();
		stuck.stream().forEach(at -> filled[at] = (float) filled(at, i -> frame[i]));
		return filled;
	}
}
