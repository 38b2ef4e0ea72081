package io.github.knotresolver.track;

import io.github.knotresolver.fit.Chain;

/**
 * What it costs a filament to move from one frame to the next: proportional to
 * the mean distance of points at equal arc length from the fixed end, which is
 * how far the material itself has moved.
 *
 * @param perPixel price of one pixel of mean motion
 */
record MotionPrice(double perPixel) {

	/** The weight that was found to work, with energies in strand intensities squared. */
	static final MotionPrice DEFAULT = new MotionPrice(1);

	double between(final Chain a, final Chain b) {
		return perPixel * a.distance(b);
	}
}
