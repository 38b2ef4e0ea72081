
package io.github.knotresolver.track;

import io.github.knotresolver.geometry.Polyline;

/**
 * How sharply a contour turns within the width of its line. No filament is seen to turn back
 * within its own width, but a contour that is pulled over a round spot does, to be as wide and
 * as bright.
 */
final class SharpestTurn {

	/** [line widths] Points that a turn is measured between lie so far apart. */
	private static final double STEP = 0.25;

	private SharpestTurn() {
	}

	/**
	 * O(length).
	 *
	 * @param contour in pixels
	 * @param sigma of the line in pixels
	 * @return the largest angle between headings that are no farther than
	 *         {@link TrackTuning#TURN_WITHIN} apart, in radians; 0 if it is shorter
	 */
	static double of(final Polyline contour, final double sigma) {
		final double step = STEP * sigma;
		final int points = (int) (contour.length() / step);
		final int apart = (int) Math
			.ceil(Math.max(TrackTuning.TURN_WITHIN * sigma, TrackTuning.TURN_LEAST) / step);
		if (points <= apart + 1)
			return 0;
		final Polyline even = contour.divided(points);
		final double[] heading = new double[points];
		for (int i = 0; i < points; i++) {
			final double angle = Math.atan2(even.y(i + 1) - even.y(i), even.x(i + 1) - even.x(i));
			heading[i] = i == 0
				? angle
				: heading[i - 1] + Math.IEEEremainder(angle - heading[i - 1], 2 * Math.PI);
		}
		double most = 0;
		for (int i = apart; i < points; i++)
			most = Math.max(most, Math.abs(heading[i] - heading[i - apart]));
		return most;
	}
}
