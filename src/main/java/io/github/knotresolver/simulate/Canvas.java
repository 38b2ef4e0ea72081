package io.github.knotresolver.simulate;

import java.util.ArrayList;
import java.util.List;

import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.model.Calibration;
import io.github.knotresolver.model.UserException;
import io.github.knotresolver.simulate.FilamentSimulator.Trajectory;

/**
 * The view of a trajectory: all frames share it. Pixel = µm / pixelSize +
 * offset.
 *
 * @param width in pixels
 * @param height in pixels
 * @param pixelSize in µm, 0.005 to 10
 * @param offsetX column of the clamped end's first place, in pixels
 * @param offsetY row of the clamped end's first place, in pixels
 * @param frameInterval time between frames in s
 */
public record Canvas(int width, int height, double pixelSize, double offsetX, double offsetY,
	double frameInterval) {

	/** Distance of points on true contours, in pixels. */
	private static final double TRUTH_STEP = 0.5;

	/** Most pixels of one frame. */
	private static final double MOST_PIXELS = 4e7;

	public Canvas {
		Require.within("pixel_size", pixelSize, 0.005, 10, "µm");
	}

	/**
	 * Checks the numbers of a view before there is a trajectory.
	 *
	 * @param pixelSize in µm
	 * @param margin in pixels
	 * @throws UserException if one is out of range
	 */
	public static void check(final double pixelSize, final int margin) {
		Require.within("pixel_size", pixelSize, 0.005, 10, "µm");
		Require.within("margin", margin, 0, 1000);
	}

	/**
	 * The smallest view that holds every frame with a margin.
	 *
	 * @param trajectory the curves in µm
	 * @param pixelSize in µm, 0.005 to 10; default 0.106
	 * @param margin in pixels, 0 to 1000; default 20
	 * @return the canvas
	 * @throws UserException if a number is out of range or a frame would
	 *           have more than 40 million pixels
	 */
	public static Canvas around(final Trajectory trajectory, final double pixelSize,
		final int margin) {
		check(pixelSize, margin);
		double left = 0, right = 0, top = 0, bottom = 0;
		for (final Polyline c : trajectory.curves())
			for (int i = 0; i < c.size(); i++) {
				left = Math.min(left, c.x(i));
				right = Math.max(right, c.x(i));
				top = Math.min(top, c.y(i));
				bottom = Math.max(bottom, c.y(i));
			}
		final double width = Math.ceil((right - left) / pixelSize) + 2 * margin + 1;
		final double height = Math.ceil((bottom - top) / pixelSize) + 2 * margin + 1;
		if (width * height > MOST_PIXELS)
			throw new UserException(
				"pixel_size " + pixelSize + " µm makes frames of " + (long) width + " x "
					+ (long) height + " pixels, more than 40 million; choose larger pixels.");
		return new Canvas((int) width, (int) height, pixelSize, margin - left / pixelSize,
			margin - top / pixelSize, trajectory.frameInterval());
	}

	/**
	 * The true contours.
	 *
	 * @param trajectory the curves in µm
	 * @return the curves in pixels, a point every half pixel
	 */
	public List<Polyline> truth(final Trajectory trajectory) {
		final List<Polyline> truth = new ArrayList<>();
		for (final Polyline curve : trajectory.curves()) {
			final double[] x = curve.xs(), y = curve.ys();
			for (int i = 0; i < x.length; i++) {
				x[i] = x[i] / pixelSize + offsetX;
				y[i] = y[i] / pixelSize + offsetY;
			}
			truth.add(Polyline.of(x, y).resampled(TRUTH_STEP));
		}
		return truth;
	}

	/** @return units of length and time */
	public Calibration calibration() {
		return new Calibration(pixelSize, "µm", frameInterval, "s");
	}
}
