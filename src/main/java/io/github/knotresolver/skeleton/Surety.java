package io.github.knotresolver.skeleton;

import io.github.knotresolver.image.LineAppearance;
import io.github.knotresolver.image.Ridges;

/** How sure a stretch of line is as a whole, however faint each of its pixels. */
final class Surety {

	private Surety() {
	}

	/**
	 * @param z mean ridge strength along a stretch, in units of noise
	 * @param length of the stretch, in working pixels
	 * @return what is above noise, over its own standard deviation
	 */
	static double of(final double z, final double length, final LineAppearance appearance) {
		return (z - SkeletonTuning.MEAN_OF_NOISE)
			* Math.sqrt(length / (SkeletonTuning.INDEPENDENT * appearance.filterSigma()));
	}

	/** @param places of a stretch's pixels, row by row */
	static double of(final int[] places, final Ridges ridges) {
		double sum = 0;
		for (final int at : places)
			sum += ridges.z(at);
		return places.length == 0 ? 0 : of(sum / places.length, places.length, ridges.appearance());
	}
}
