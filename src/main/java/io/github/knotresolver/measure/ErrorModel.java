
package io.github.knotresolver.measure;

import java.util.Collection;
import java.util.function.ToDoubleFunction;

import org.apache.commons.math3.stat.descriptive.rank.Median;

import io.github.knotresolver.geometry.RobustStatistics;
import io.github.knotresolver.measure.ErrorCorrelation.Kind;

/**
 * What is known of the errors of contours that were smoothed in the same way.
 *
 * @param fit what they do to the smoothed curve
 * @param residual what they leave in the residuals that tell their size
 * @param held whether the contours have been held at one length: their lengths
 *          scatter less from frame to frame than their points do, which points
 *          that are free cannot
 */
record ErrorModel(NoiseGain fit, NoiseGain residual, boolean held) {

	/**
	 * Learns how errors of neighbouring points are correlated from the residuals of all contours
	 * together. Contours that have been held at one length come from a fit, whose
	 * errors are smooth.
	 *
	 * @param contours at least one
	 * @param order degree of the smoothing's polynomial
	 */
	static ErrorModel learn(final Collection<SmoothedContour> contours, final int order) {
		return of(contours, order, Kind.SMOOTH).isHeld(contours)
			? of(contours, order, Kind.FITTED)
			: of(contours, order, Kind.ANY);
	}

	private static ErrorModel of(final Collection<SmoothedContour> contours, final int order,
		final Kind kind) {
		final LocalFilter fit = filter(contours, k -> k.curve().windowPoints(), order);
		final LocalFilter wide = filter(contours, k -> k.wide().windowPoints(), order);
		final ErrorCorrelation correlation = ErrorCorrelation
			.of(contours.stream().map(SmoothedContour::wide).toList(), wide, kind);
		final NoiseGain residual = new NoiseGain(order, wide.points(), correlation);
		final NoiseGain same = fit.points() == wide.points()
			? residual
			: new NoiseGain(order, fit.points(), correlation);
		return new ErrorModel(same, residual, kind == Kind.FITTED);
	}

	/** @return over how many points errors are correlated */
	double correlated() {
		return residual.along();
	}

	private boolean isHeld(final Collection<SmoothedContour> contours) {
		if (contours.size() < MeasureTuning.FEWEST_LENGTHS)
			return false;
		final double length = median(contours, SmoothedContour::traced);
		final double scatter = RobustStatistics.MAD_TO_SD
			* median(contours, k -> Math.abs(k.traced() - length));
		return scatter < median(contours, k -> k.wide().sigma(residual));
	}

	/** The filter of the contours' median window. */
	private static LocalFilter filter(final Collection<SmoothedContour> contours,
		final ToDoubleFunction<SmoothedContour> points, final int order) {
		return new LocalFilter(order, (int) Math.rint(median(contours, points)) + 1);
	}

	private static double median(final Collection<SmoothedContour> contours,
		final ToDoubleFunction<SmoothedContour> value) {
		return new Median().evaluate(contours.stream().mapToDouble(value).toArray());
	}

	ContourGeometry.CurveNoise noise(final SmoothedContour contour) {
		return contour.curve().noise(contour.wide().sigma(residual), held, fit);
	}
}
