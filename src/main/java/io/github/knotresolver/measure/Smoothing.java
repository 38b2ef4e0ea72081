
package io.github.knotresolver.measure;

import java.util.Collection;
import java.util.List;

import io.github.knotresolver.geometry.Calibration;
import io.github.knotresolver.geometry.Polyline;

/**
 * How a contour is smoothed along its arc length: Savitzky and Golay's filter
 * (1964, doi:10.1021/ac60214a047) fits a polynomial to the points of a moving
 * window and takes its value and derivatives in the middle.
 *
 * @param window full width of the window in the unit of length, above 0
 * @param order degree of the polynomial, 2 to 5
 */
public record Smoothing(double window, int order) {

	/** Cubic: bends and turns of bending are followed, ends stay calm. */
	public static final int DEFAULT_ORDER = 3;

	public Smoothing {
		if (!(window > 0) || Double.isInfinite(window))
			throw new IllegalArgumentException(
				"The smoothing window must be above 0, but is " + window + ".");
		if (order < 2 || order > 5)
			throw new IllegalArgumentException(
				"The smoothing order must be from 2 to 5, but is " + order + ".");
	}

	/**
	 * The cubic smoothing that predicts points best which it has not seen:
	 * cross-validation over the window's width, leaving out a point together with
	 * its near neighbours (whose errors resemble its own). So the window follows
	 * the data: wide where points are noisy and the filament is straight, narrow
	 * where they are exact or the filament is tightly bent. One window for all
	 * contours of a movie makes their curvatures comparable. The width is that for
	 * the curvature, 7 % less than for the points. O(points × widths), bounded by a
	 * sample of the points.
	 *
	 * @param contoursPx contours in pixels, at least one with three points
	 * @param c calibration
	 * @return the smoothing
	 * @throws IllegalArgumentException if no contour can be measured
	 */
	public static Smoothing derivedFrom(final Collection<Polyline> contoursPx,
		final Calibration c) {
		final List<Samples> samples = contoursPx.stream().filter(ContourGeometry::isMeasurable)
			.map(p -> Samples.of(p, c.pixelSize())).toList();
		if (samples.isEmpty())
			throw new IllegalArgumentException("None of the " + contoursPx.size()
				+ " contours has three points or more, so there is nothing to smooth; check whether any frame was resolved.");
		return new WindowChoice(samples, c.pixelSize()).best();
	}
}
