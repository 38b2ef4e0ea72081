
package io.github.knotresolver.measure;

/**
 * The noise of a contour's points and what it does to the smoothed curve.
 *
 * @param sigma standard deviation of a point across the curve, in the unit of
 *          length, estimated from the residuals of a smoothing that is wide
 *          enough to show it (see {@link ErrorModel})
 * @param inflation by how much the errors of neighbouring points, being correlated,
 *          widen the variance of an average over many: 1 if they are
 *          independent
 * @param held whether the contours were held at one length, as those of a fit are
 * @param across standard error of each smoothed point across the curve, in the
 *          unit of length
 * @param tangentAngle standard error of each tangent angle, radians
 * @param curvature standard error of each curvature, 1/unit of length
 */
public record CurveNoise(double sigma, double inflation, boolean held, double[] across,
	double[] tangentAngle, double[] curvature) {
}
