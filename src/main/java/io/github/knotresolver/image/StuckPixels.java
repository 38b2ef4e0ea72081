package io.github.knotresolver.image;

import java.util.Arrays;
import java.util.BitSet;
import java.util.function.IntToDoubleFunction;
import java.util.stream.IntStream;

import io.github.knotresolver.geometry.RobustStatistics;

/**
 * Pixels of a camera that are far too bright in all frames, "hot" ones. Their shape tells: light
 * that came through a lens reaches the neighbours, too, and these do not. At most one of a
 * pixel's neighbours may be another one.
 */
public final class StuckPixels {

	/** Of a surface that is smooth across a pixel: twice the mean of its sides, less that of its corners. */
	private static final double SIDE = 0.5, CORNER = -0.25;

	private static final int[][] SIDES = {{1, 0}, {-1, 0}, {0, 1}, {0, -1}},
		CORNERS = {{1, 1}, {-1, 1}, {1, -1}, {-1, -1}};

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
		final double[] around = around(at).mapToDouble(i -> still[i]).sorted().toArray();
		final double second = around[around.length - 2], above = still[at] - second;
		return above > least && above > ImageTuning.STUCK_ALONE * (second - around[0]);
	}

	/** The neighbours that are in the picture; at least three. */
	private IntStream around(final int at) {
		return IntStream.concat(beside(at, SIDES), beside(at, CORNERS));
	}

	private IntStream beside(final int at, final int[][] steps) {
		final int x = at % width, y = at / width;
		return Arrays.stream(steps)
			.filter(s -> x + s[0] >= 0 && x + s[0] < width && y + s[1] >= 0 && y + s[1] < height)
			.mapToInt(s -> at + s[1] * width + s[0]);
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
		final int[] left = around(at).filter(i -> !stuck.get(i)).toArray();
		if (left.length < SIDES.length + CORNERS.length)
			return Arrays.stream(left).mapToDouble(values).average()
				.orElseGet(() -> values.applyAsDouble(at));
		return SIDE * beside(at, SIDES).mapToDouble(values).sum()
			+ CORNER * beside(at, CORNERS).mapToDouble(values).sum();
	}
}
