package io.github.knotresolver.track;

import io.github.knotresolver.fit.NormalizedFrame;
import io.github.knotresolver.geometry.Polyline;

/**
 * The part of a contour inside the picture: a filament may leave it, and what is outside
 * cannot be seen.
 *
 * @param contour up to where it first leaves the picture, at least two points
 * @param share that part's share of the length, 0..1
 */
record Visible(Polyline contour, double share) {

	/** A pixel reaches half a pixel beyond its centre: as far as is surely in it when rounded. */
	private static final double HALF = 0.499;

	/**
	 * @param contour in pixels, fixed end first, at least two points
	 * @param frame the picture
	 * @return the part inside; the whole contour if it begins outside
	 */
	static Visible of(final Polyline contour, final NormalizedFrame frame) {
		int inside = 0;
		while (inside < contour.size() && beyond(contour, inside, frame) < 0)
			inside++;
		if (inside < 2 || inside == contour.size())
			return new Visible(contour, 1);
		double length = 0;
		for (int i = 1; i < inside; i++)
			length += contour.point(i).distanceTo(contour.point(i - 1));
		final double last = -beyond(contour, inside - 1, frame),
			next = beyond(contour, inside, frame);
		length += last / (last + next)
			* contour.point(inside).distanceTo(contour.point(inside - 1));
		return new Visible(contour.head(length), length / contour.length());
	}

	/** How far a point is outside the picture, in pixels; below 0 inside. */
	private static double beyond(final Polyline contour, final int i, final NormalizedFrame frame) {
		return Math.max(Math.max(-contour.x(i), contour.x(i) - (frame.width() - 1)),
			Math.max(-contour.y(i), contour.y(i) - (frame.height() - 1))) - HALF;
	}
}
