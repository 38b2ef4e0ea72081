
package io.github.knotresolver.measure;

import java.util.List;

import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.model.Calibration;

/**
 * A contour's geometry at each of its points, in calibrated units: the curve is
 * smoothed along its arc length with Savitzky and Golay's filter (1964,
 * doi:10.1021/ac60214a047), and tangent, normal and curvature follow from the
 * derivatives r', r'' of the local polynomial by the Frenet-Serret formulas:
 * <p>
 * ψ = atan2(y', x'), κ = (x' y'' - y' x'') / |r'|³, arc length = ∫ |r'|.
 * <p>
 * Angles are in radians in the image's axes, y pointing DOWN: from the x axis
 * towards the y axis, clockwise on the screen; κ = dψ/ds has the same sense.
 * The ends are evaluated on the polynomial of the last full window, so the
 * contour keeps its length; their variance is larger, and the standard errors
 * say so. O(n × window).
 */
public final class ContourGeometry {

	private final Smoothing smoothing;
	private final double pixelSize;
	private final double[] arcLength;
	private final double[] x;
	private final double[] y;
	private final double[] tangentAngle;
	private final double[] curvature;
	private final CurveNoise noise;
	private final Estimate bending;
	private final double[][] shift;

	ContourGeometry(final SmoothedContour contour, final Smoothing smoothing,
		final double pixelSize, final ErrorModel errors) {
		final SmoothedCurve curve = contour.curve();
		this.smoothing = smoothing;
		this.pixelSize = pixelSize;
		this.x = curve.x();
		this.y = curve.y();
		this.tangentAngle = curve.tangentAngle();
		this.curvature = curve.curvature();
		this.noise = errors.noise(contour);
		this.shift = curve.shift();
		this.arcLength = errors.held()
			? curve.arcLength()
			: curve.arcLength(noise.sigma(), errors.fit());
		this.bending = curve.bending(noise, errors.fit(),
			Math.min(smoothing.window(), arcLength[arcLength.length - 1]));
	}

	/**
	 * Measures a contour with the smoothing derived from itself. For the contours
	 * of one movie, derive one smoothing from all of them and use
	 * {@link #of(Polyline, Calibration, Smoothing)}.
	 *
	 * @param contourPx a contour in pixels, fixed end first, three points or more
	 * @param c calibration
	 * @return its geometry, at the contour's own points
	 * @throws IllegalArgumentException if the contour has fewer than three points
	 *           or no length
	 */
	public static ContourGeometry of(final Polyline contourPx, final Calibration c) {
		requireMeasurable(contourPx);
		return of(contourPx, c, Smoothing.derivedFrom(List.of(contourPx), c));
	}

	/**
	 * Measures a contour.
	 *
	 * @param contourPx a contour in pixels, fixed end first, three points or more
	 * @param c calibration
	 * @param smoothing window and order; the order is lowered for contours of few
	 *          points
	 * @return its geometry, at the contour's own points
	 * @throws IllegalArgumentException if the contour has fewer than three points
	 *           or no length
	 */
	public static ContourGeometry of(final Polyline contourPx, final Calibration c,
		final Smoothing smoothing) {
		requireMeasurable(contourPx);
		final SmoothedContour contour = SmoothedContour.of(contourPx, c, smoothing);
		return new ContourGeometry(contour, smoothing, c.pixelSize(),
			ErrorModel.learn(List.of(contour), smoothing.order()));
	}

	/**
	 * @param contourPx a contour
	 * @return whether it can be measured: three points or more, and a length
	 */
	public static boolean isMeasurable(final Polyline contourPx) {
		return contourPx.size() >= 3 && contourPx.length() > 0;
	}

	private static void requireMeasurable(final Polyline contourPx) {
		if (!isMeasurable(contourPx))
			throw new IllegalArgumentException(
				"A contour must have at least 3 points and a length above 0 to be measured, but this one has "
					+ contourPx.size() + " points and a length of " + contourPx.length()
					+ " px; leave this frame out or correct it.");
	}

	/** @return the number of points */
	public int size() {
		return x.length;
	}

	/** @return the smoothing that was asked for */
	public Smoothing smoothing() {
		return smoothing;
	}

	/** @return arc length from the fixed end, in the unit of length */
	public double[] arcLength() {
		return arcLength.clone();
	}

	/** @return columns of the smoothed curve, in the unit of length */
	public double[] x() {
		return x.clone();
	}

	/** @return rows of the smoothed curve, in the unit of length */
	public double[] y() {
		return y.clone();
	}

	/**
	 * @return tangent angle in radians, unwrapped along the contour; the first is
	 *         in -π..π
	 */
	public double[] tangentAngle() {
		return tangentAngle.clone();
	}

	/** @return signed curvature in 1/unit of length */
	public double[] curvature() {
		return curvature.clone();
	}

	/** @return the noise of the points and the standard errors it causes */
	public CurveNoise noise() {
		return noise;
	}

	/**
	 * What smoothing may have moved: columns, rows and speeds of the polynomial two
	 * orders higher, less those of the curve.
	 */
	double[][] shift() {
		return shift;
	}

	/**
	 * @return ½ ∫ κ² ds in 1/unit of length: the bending energy of a filament of
	 *         rigidity 1. What noise adds on average is taken off, so a straight
	 *         noisy filament scatters about 0.
	 */
	public Estimate bendingIntegral() {
		return bending;
	}

	/** @return length of the smoothed curve, in the unit of length */
	public double length() {
		return arcLength[arcLength.length - 1];
	}

	/** @return distance of the two ends, in the unit of length */
	public double endToEnd() {
		return Math.hypot(x[x.length - 1] - x[0], y[y.length - 1] - y[0]);
	}

	/** @return tangent angle at the free tip, radians, unwrapped from the base */
	public double tipAngle() {
		return tangentAngle[tangentAngle.length - 1];
	}

	/** @return the smoothed curve, in pixels */
	public Polyline smoothedPx() {
		final double[] px = new double[x.length], py = new double[y.length];
		for (int i = 0; i < px.length; i++) {
			px[i] = x[i] / pixelSize;
			py[i] = y[i] / pixelSize;
		}
		return Polyline.of(px, py);
	}

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
}
