
package io.github.knotresolver.measure;

import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.model.Calibration;

/**
 * A contour, smoothed twice: as asked for, and over a window that is wide enough
 * to see its noise.
 *
 * @param curve the smoothed curve
 * @param wide the curve whose residuals tell the noise; the same if its window
 *          is wide enough
 * @param traced length of the chain of points
 */
record SmoothedContour(SmoothedCurve curve, SmoothedCurve wide, double traced) {

	static SmoothedContour of(final Polyline contourPx, final Calibration c,
		final Smoothing smoothing) {
		final Samples raw = Samples.of(contourPx, c.pixelSize());
		final int order = Math.min(smoothing.order(), contourPx.size() - 1);
		final int least = order + MeasureTuning.SPARE_POINTS;
		final double window = Math.min(smoothing.window(), raw.length());
		// Noise makes a chain of points longer than its curve; the window is
		// meant in lengths of the curve, so arc length is found first.
		final double[] arc = SmoothedCurve.of(raw, window, order, least).arcLength();
		final double length = arc[arc.length - 1], width = Math.min(window, length);
		final Samples samples = raw.over(arc);
		final SmoothedCurve curve = SmoothedCurve.of(samples, width, order, least).withBias(width,
			order, least);
		final double wide = Math.min(length, MeasureTuning.NOISE_WINDOW * c.pixelSize());
		return new SmoothedContour(curve,
			wide > width ? SmoothedCurve.of(samples, wide, order, least) : curve, raw.length());
	}
}
