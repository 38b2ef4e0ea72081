package io.github.knotresolver.skeleton;

import java.util.Arrays;

import io.github.knotresolver.image.Ridges;

/**
 * Shortens lines to where their light ends. Beyond a tip, noise and the tip's own blur
 * draw the line on.
 */
final class EndTrimmer {

	private final Ridges ridges;
	private final int ahead;
	private final double faint;

	EndTrimmer(final Ridges ridges) {
		this.ridges = ridges;
		ahead = Math.max(1,
			(int) (SkeletonTuning.END_STRETCH * ridges.appearance().blurredSigma()));
		faint = Math.min(SkeletonTuning.FAINT_TAIL,
			SkeletonTuning.FAINT_SHARE * ridges.appearance().clarity());
	}

	/** Cuts the free ends of a line. O(ends * line width). */
	void trim(final LinePixels line) {
		for (final int end : line.ends()) {
			final int[] path = line.walk(end, (int) Math.ceil(SkeletonTuning.END_FARTHEST
				* SkeletonTuning.END_STRETCH * ridges.appearance().blurredSigma()));
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
				return i > 0
					&& Surety.of(sum / i, i, ridges.appearance()) < SkeletonTuning.SURE_TAIL
						? i
						: 0;
			sum += z;
		}
		return 0;
	}

	/** @return the first pixel from a place on that is bright enough for an end */
	private int beyond(final LinePixels line, final int[] path, final int from) {
		final double[] drops = Arrays.stream(path).mapToDouble(at -> ridges.drop(line.inside(at)))
			.toArray();
		int i = from;
		while (i < path.length - 1 && drops[i] < SkeletonTuning.END_SHARE * quantile(drops, i))
			i++;
		return i;
	}

	private double quantile(final double[] drops, final int from) {
		final double[] part = Arrays.copyOfRange(drops, from,
			Math.min(drops.length, from + ahead + 1));
		Arrays.sort(part);
		final double place = SkeletonTuning.END_QUANTILE * (part.length - 1);
		final int below = (int) place;
		return part[below]
			+ (place - below) * (part[Math.min(below + 1, part.length - 1)] - part[below]);
	}
}
