
package io.github.knotresolver.measure;

import java.util.List;
import java.util.Optional;

import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.model.Calibration;

/**
 * How far and how fast a filament glides along itself, from its trailing to its leading end.
 * Between two frames it has slid by the mean, over points at equal arc length, of their motion
 * along the filament; what moves it sideways is no gliding.
 *
 * @param path the sum over all pairs of neighbouring frames that have a contour, forwards
 *          less backwards, in the unit of length
 * @param speed the path by the time in which it was covered, in units of length by units
 *          of time
 * @param steps over how many pairs of frames
 */
public record Gliding(double path, double speed, int steps) {

	/**
	 * O(frames).
	 *
	 * @param contours of one filament, by frame, in pixels
	 * @param calibration pixel size and frame interval
	 * @return empty if no two neighbouring frames have a contour
	 */
	public static Optional<Gliding> of(final List<Optional<Polyline>> contours,
		final Calibration calibration) {
		double path = 0;
		int steps = 0;
		for (int t = 0; t + 1 < contours.size(); t++)
			if (isCurve(contours.get(t)) && isCurve(contours.get(t + 1))) {
				path += slide(contours.get(t).get(), contours.get(t + 1).get());
				steps++;
			}
		if (steps == 0)
			return Optional.empty();
		final double length = path * calibration.pixelSize();
		return Optional
			.of(new Gliding(length, length / (steps * calibration.frameInterval()), steps));
	}

	private static boolean isCurve(final Optional<Polyline> contour) {
		return contour.filter(c -> c.length() > 0).isPresent();
	}

	/** How far a curve has slid along itself, in pixels. */
	private static double slide(final Polyline before, final Polyline after) {
		final Polyline a = before.divided(MeasureTuning.GLIDING_POINTS),
			b = after.divided(MeasureTuning.GLIDING_POINTS);
		double sum = 0;
		for (int i = 0; i < MeasureTuning.GLIDING_POINTS; i++) {
			final double ux = b.x(i + 1) - b.x(i), uy = b.y(i + 1) - b.y(i);
			final double mx = 0.5 * (b.x(i) + b.x(i + 1) - a.x(i) - a.x(i + 1));
			final double my = 0.5 * (b.y(i) + b.y(i + 1) - a.y(i) - a.y(i + 1));
			sum += (mx * ux + my * uy) / Math.max(1e-9, Math.hypot(ux, uy));
		}
		return sum / MeasureTuning.GLIDING_POINTS;
	}
}
