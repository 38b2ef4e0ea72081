package io.github.knotresolver.track;

import io.github.knotresolver.fit.Chain;

/**
 * What it costs a filament to move from one frame to the next: how far points at
 * equal arc length from the fixed end, that is the material itself, have moved, and
 * how far they have turned. A loop that is run the other way round in the next frame
 * covers the same pixels, but has turned by a full turn.
 *
 * @param perPixel price of one pixel of mean motion
 * @param perRadian price of one radian of mean turn
 */
record MotionPrice(double perPixel, double perRadian) {

	/** The weights that were found to work, with energies in strand intensities squared. */
	static final MotionPrice DEFAULT = new MotionPrice(
		Double.parseDouble(System.getProperty("pp", "1")),
		Double.parseDouble(System.getProperty("pr", "4")));

	double between(final Chain a, final Chain b) {
		return perPixel * a.distance(b) + perRadian * a.turn(b);
	}
}
