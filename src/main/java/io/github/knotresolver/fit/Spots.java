package io.github.knotresolver.fit;

import java.util.Arrays;
import java.util.List;

import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.image.GaussianBlur;

/**
 * Round bright spots in what a chain leaves of a movie.
 *
 * @param light of the spots for every pixel, in strands' brightnesses; 0 elsewhere
 */
public record Spots(double[] light) {

	/** A spot is at least so bright (strands) where it is blurred by a line's width. */
	private static final double BRIGHT = 0.3;

	/** Its curvature along is at least this part of that across. */
	private static final double ROUND = 0.5;

	/** It reaches at least and at most so many line widths (sigma). */
	private static final double LEAST_REACH = 2, MOST_REACH = 8;

	/** It ends where less than this (strands) is left around it. */
	private static final double DARK = 0.08;

	/** Where a spot is brighter than this (strands), its noise drowns a line: nothing is seen. */
	private static final double DAZZLING = 2;

	/** Below any light. */
	private static final double NOTHING_SEEN = -1e9;

	/**
	 * What a chain leaves of a frame.
	 *
	 * @param frame the frame, a strand's brightness 1
	 * @param model what a line looks like
	 * @param chain the chain
	 * @return light less picture for every pixel
	 */
	public static double[] residual(final NormalizedFrame frame, final LineModel model,
		final Chain chain) {
		final double[] left = ChainPixels.draw(frame, model, chain), pixels = frame.pixels();
		for (int i = 0; i < left.length; i++)
			left[i] = frame.residual(i, pixels[i], left[i], model);
		return left;
	}

	/**
	 * Looks for spots. O(pixels).
	 *
	 * @param left what is left all the time, in strands' brightnesses
	 * @param sigma of a line in pixels
	 * @param ends places at which nothing is taken for a spot
	 * @param near so near to them (pixels)
	 * @return the spots
	 */
	public static Spots in(final NormalizedFrame left, final double sigma, final List<Point> ends,
		final double near) {
		final float[] values = new float[left.pixels().length];
		for (int i = 0; i < values.length; i++)
			values[i] = (float) left.pixels()[i];
		final int width = left.width();
		final float[] calm = GaussianBlur.blur(values, width, sigma);
		final double[] light = new double[values.length];
		for (int y = 1; y + 1 < left.height(); y++)
			for (int x = 1; x + 1 < width; x++) {
				final Point here = new Point(x, y);
				if (calm[y * width + x] > BRIGHT && isRoundTop(calm, width, x, y)
					&& ends.stream().allMatch(e -> e.distanceTo(here) > near))
					add(left, here, reach(left, here, sigma), light);
			}
		return new Spots(light);
	}

	/** Whether a pixel is a local maximum whose curvature is the same in all directions, about. */
	private static boolean isRoundTop(final float[] v, final int width, final int x, final int y) {
		final int at = y * width + x;
		for (int dy = -1; dy <= 1; dy++)
			for (int dx = -1; dx <= 1; dx++)
				if (v[at + dy * width + dx] > v[at])
					return false;
		final double xx = v[at - 1] - 2 * v[at] + v[at + 1];
		final double yy = v[at - width] - 2 * v[at] + v[at + width];
		final double xy = (v[at + width + 1] - v[at + width - 1] - v[at - width + 1]
			+ v[at - width - 1]) / 4;
		final double middle = (xx + yy) / 2, half = Math.hypot((xx - yy) / 2, xy);
		return middle + half <= ROUND * (middle - half);
	}

	/** How far a spot reaches. */
	private static double reach(final NormalizedFrame left, final Point spot, final double sigma) {
		double reach = LEAST_REACH * sigma;
		while (reach < MOST_REACH * sigma && around(left, spot, reach) > DARK)
			reach++;
		return reach;
	}

	/** Mean of the ring of a radius. */
	private static double around(final NormalizedFrame left, final Point spot,
		final double radius) {
		double sum = 0;
		int count = 0;
		final int steps = (int) Math.ceil(2 * Math.PI * radius);
		for (int k = 0; k < steps; k++) {
			final double angle = 2 * Math.PI * k / steps;
			final double value = left.meanAround(spot.x() + radius * Math.cos(angle),
				spot.y() + radius * Math.sin(angle));
			if (Double.isFinite(value)) {
				sum += value;
				count++;
			}
		}
		return count == 0 ? 0 : sum / count;
	}

	private static void add(final NormalizedFrame left, final Point spot, final double reach,
		final double[] light) {
		final int r = (int) Math.ceil(reach);
		final int cx = (int) spot.x(), cy = (int) spot.y();
		for (int y = Math.max(0, cy - r); y <= Math.min(left.height() - 1, cy + r); y++)
			for (int x = Math.max(0, cx - r); x <= Math.min(left.width() - 1, cx + r); x++)
				if (Math.hypot(x - cx, y - cy) <= reach)
					light[y * left.width() + x] = Math.max(0, left.pixels()[y * left.width() + x]);
	}

	/** @return whether there is no spot */
	public boolean isEmpty() {
		return Arrays.stream(light).allMatch(l -> l == 0);
	}

	/**
	 * @param frame a frame
	 * @param strand brightness of a strand in it
	 * @return the same without the spots' light; of pixels where they dazzle nothing is known
	 */
	public NormalizedFrame takenOff(final NormalizedFrame frame, final double strand) {
		final double[] pixels = frame.pixels().clone(), ceiling = new double[pixels.length];
		Arrays.fill(ceiling, Double.POSITIVE_INFINITY);
		if (frame.isClipped())
			System.arraycopy(frame.ceiling(), 0, ceiling, 0, ceiling.length);
		for (int i = 0; i < pixels.length; i++) {
			pixels[i] -= strand * light[i];
			if (light[i] > DAZZLING) {
				pixels[i] = 0;
				ceiling[i] = NOTHING_SEEN * strand;
			}
		}
		return new NormalizedFrame(frame.width(), frame.height(), pixels).withCeiling(ceiling)
			.withWidening(frame.widening());
	}
}
