
package io.github.knotresolver.measure;

import java.util.Collection;
import java.util.List;
import java.util.stream.IntStream;

import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.model.Calibration;
import io.github.knotresolver.model.UserException;

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
			throw new UserException("The smoothing window must be above 0, but is " + window + ".");
		if (order < 2 || order > 5)
			throw new UserException(
				"The smoothing order must be from 2 to 5, but is " + order + ".");
	}

	/**
	 * The cubic smoothing that predicts points best which it has not seen:
	 * cross-validation over the window's width, leaving out a point together with
	 * its near neighbours, as far as their errors resemble its own. So the window follows
	 * the data: wide where points are noisy and the filament is straight, narrow
	 * where they are exact or the filament is tightly bent. One window for all
	 * contours of a movie makes their curvatures comparable. The width is that for
	 * the curvature, 0.85 of that for the points. O(points × widths), bounded by a
	 * sample of the points.
	 *
	 * @param contoursPx contours in pixels, at least one with three points
	 * @param c calibration
	 * @return the smoothing
	 * @throws UserException if no contour can be measured
	 */
	public static Smoothing derivedFrom(final Collection<Polyline> contoursPx,
		final Calibration c) {
		final List<Samples> samples = contoursPx.stream().filter(ContourGeometry::isMeasurable)
			.map(p -> Samples.of(p, c.pixelSize())).toList();
		if (samples.isEmpty())
			throw new UserException("None of the " + contoursPx.size()
				+ " contours has three points or more, so there is nothing to smooth; check whether any frame was resolved.");
		final WindowChoice choice = new WindowChoice(samples, c.pixelSize());
		final List<Polyline> some = sample(contoursPx);
		final Smoothing narrow = choice.best(MeasureTuning.NEIGHBOURS * c.pixelSize());
		if (narrow.errors(some, c).held())
			return narrow;
		final Smoothing wide = choice.best(MeasureTuning.FAR * c.pixelSize());
		// Where the filament itself bends too much to be predicted from afar, what
		// looks like correlated errors is the filament.
		if (choice.error(wide, MeasureTuning.FAR * c.pixelSize()) > MeasureTuning.FAR_WORSE
			* choice.error(narrow, MeasureTuning.NEIGHBOURS * c.pixelSize()))
			return narrow;
		final double range = wide.errors(some, c).correlated() * spacing(samples) / c.pixelSize();
		return range > MeasureTuning.NEIGHBOURS ? choice.best(range * c.pixelSize()) : narrow;
	}

	private ErrorModel errors(final List<Polyline> contoursPx, final Calibration c) {
		return ErrorModel
			.learn(contoursPx.stream().map(p -> SmoothedContour.of(p, c, this)).toList(), order);
	}

	private static List<Polyline> sample(final Collection<Polyline> contoursPx) {
		final List<Polyline> all = contoursPx.stream().filter(ContourGeometry::isMeasurable)
			.toList();
		final int stride = (all.size() + MeasureTuning.WINDOW_CONTOURS - 1)
			/ MeasureTuning.WINDOW_CONTOURS;
		return IntStream.range(0, all.size() / stride).mapToObj(i -> all.get(i * stride)).toList();
	}

	private static double spacing(final List<Samples> contours) {
		return contours.stream().mapToDouble(Samples::spacing).average().orElseThrow();
	}
}
