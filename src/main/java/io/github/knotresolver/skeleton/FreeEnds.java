package io.github.knotresolver.skeleton;

import java.util.Arrays;

import io.github.knotresolver.image.Ridges;

/**
 * Shortens lines to where their light ends. Beyond a tip, noise and the tip's own blur
 * draw the line on.
 */
final class FreeEnds {

	/** A free end lies where the contrast is this part ... */
	private static final double SHARE = 0.5;

	/** ... of this quantile of what follows within so many line widths. */
	private static final double QUANTILE = 0.75, AHEAD = 3;

	/** How far, in the same stretches, an end may be moved. */
	private static final double FARTHEST = 3;

	/** A faint tail is one weaker than this many times its noise, or this part of what is usual. */
	private static final double FAINT = 5, FAINT_SHARE = 0.5;

	/** A tail must be as sure as this as a whole. */
	private static final double SURE = 3;

	private final Ridges ridges;
	private final int ahead;
	private final double faint;

	FreeEnds(final Ridges ridges) {
		this.ridges = ridges;
		ahead = Math.max(1, (int) (AHEAD * ridges.appearance().blurredSigma()));
		faint = Math.min(FAINT, FAINT_SHARE * ridges.appearance().clarity());
	}

	/** Cuts the free ends of a line. O(ends * line width). */
	void trim(final LinePixels line) {
		for (final int end : line.ends()) {
			final int[] path = line.walk(end,
				(int) Math.ceil(FARTHEST * AHEAD * ridges.appearance().blurredSigma()));
			final int tail = tail(line, path);
			for (int i = 0; i < Math.max(tail, beyond(line, path, tail)); i++)
				line.remove(path[i]);
		}
	}

	/** @return number of pixels of a faint tail that is not sure enough */
	private int tail(final LinePixels line, final int[] path) {
		double sum = 0;
		for (int i = 0; i < path.length; i++) {
			final double z = ridges.z(line.inside(path[i]));
			if (z >= faint)
				return i > 0 && Surety.of(sum / i, i, ridges.appearance()) < SURE ? i : 0;
			sum += z;
		}
		return 0;
	}

	/** @return the first pixel from a place on that is bright enough for an end */
	private int beyond(final LinePixels line, final int[] path, final int from) {
		final double[] drops = Arrays.stream(path).mapToDouble(at -> ridges.drop(line.inside(at)))
			.toArray();
		int i = from;
		while (i < path.length - 1 && drops[i] < SHARE * quantile(drops, i))
			i++;
		return i;
	}

	private double quantile(final double[] drops, final int from) {
		final double[] part = Arrays.copyOfRange(drops, from,
			Math.min(drops.length, from + ahead + 1));
		Arrays.sort(part);
		final double place = QUANTILE * (part.length - 1);
		final int below = (int) place;
		return part[below]
			+ (place - below) * (part[Math.min(below + 1, part.length - 1)] - part[below]);
	}
}
