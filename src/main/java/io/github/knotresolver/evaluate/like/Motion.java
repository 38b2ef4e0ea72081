package io.github.knotresolver.evaluate.like;

import java.util.List;
import java.util.Optional;

import org.apache.commons.math3.stat.descriptive.rank.Median;

import io.github.knotresolver.geometry.Polyline;

/**
 * How a filament moves, in figures that simulated and real movies share: medians
 * over frames or over pairs of neighbouring frames, if nothing else is said.
 *
 * @param tipStep way of the free tip between frames in pixels
 * @param contourStep mean way between frames of all points at equal arc length,
 *          in pixels
 * @param knotted share of the frames in which the filament comes nearer to
 *          itself than the width of its line, or crosses itself; 0..1
 * @param extension end-to-end distance over length, 0..1
 * @param straightest the largest such share of all frames
 * @param turning how far the tangent turns along the filament, whichever way, in
 *          full turns
 */
public record Motion(double tipStep, double contourStep, double knotted, double extension,
	double straightest, double turning) {

	/** Steps below this, in pixels, cannot be told from noise. */
	private static final double LEAST_STEP = 0.1;

	/** Bending below this, in turns, is no different from straight. */
	private static final double LEAST_TURNING = 0.1;

	private static final double KNOTTED = 2, EXTENSION = 1;

	/**
	 * @param contours one entry a frame; empty where a frame has none
	 * @param width of the line in pixels
	 * @return the motion; NaN where nothing tells it
	 */
	static Motion of(final List<Optional<Polyline>> contours, final double width) {
		return ofShapes(
			contours.stream().map(c -> c.map(p -> Shape.of(p, width)).orElse(null)).toList());
	}

	/** Shapes may be null: a frame without contour. */
	static Motion ofShapes(final List<Shape> shapes) {
		final double[] tip = new double[Math.max(0, shapes.size() - 1)];
		final double[] whole = new double[tip.length];
		int pairs = 0;
		for (int t = 1; t < shapes.size(); t++) {
			if (shapes.get(t) == null || shapes.get(t - 1) == null)
				continue;
			tip[pairs] = shapes.get(t).tipWay(shapes.get(t - 1));
			whole[pairs++] = shapes.get(t).meanWay(shapes.get(t - 1));
		}
		final List<Shape> present = shapes.stream().filter(s -> s != null).toList();
		return new Motion(new Median().evaluate(tip, 0, pairs),
			new Median().evaluate(whole, 0, pairs),
			present.stream().mapToDouble(s -> s.knotted() ? 1 : 0).average().orElse(Double.NaN),
			new Median().evaluate(present.stream().mapToDouble(Shape::extension).toArray()),
			present.stream().mapToDouble(Shape::extension).max().orElse(Double.NaN),
			new Median().evaluate(present.stream().mapToDouble(Shape::turning).toArray()));
	}

	/**
	 * How unlike two motions are: squared differences, of steps and turning in
	 * their logarithms, of the rest as they are.
	 *
	 * @param other another motion
	 * @return 0 if they are alike
	 */
	double unlike(final Motion other) {
		final double tip = ratio(tipStep, other.tipStep, LEAST_STEP);
		final double whole = ratio(contourStep, other.contourStep, LEAST_STEP);
		final double bent = ratio(turning, other.turning, LEAST_TURNING);
		final double knots = KNOTTED * (knotted - other.knotted);
		final double ends = EXTENSION * (extension - other.extension);
		final double straight = EXTENSION * (straightest - other.straightest);
		return tip * tip + whole * whole + bent * bent + knots * knots + ends * ends
			+ straight * straight;
	}

	/**
	 * @param pixelSize edge of a pixel, in the unit of the steps
	 * @return the same with steps in pixels
	 */
	Motion inPixels(final double pixelSize) {
		return new Motion(tipStep / pixelSize, contourStep / pixelSize, knotted, extension,
			straightest, turning);
	}

	private static double ratio(final double a, final double b, final double least) {
		return Math.log(Math.max(a, least) / Math.max(b, least));
	}

	/**
	 * One frame's contour as the motion looks at it: points at equal arc length, and
	 * what they say together.
	 *
	 * @param points at equal arc length
	 * @param knotted whether strands cross or touch
	 * @param turning how far it turns along its length, left and right, in full turns
	 */
	record Shape(Polyline points, boolean knotted, double turning) {

		private static final int LINKS = 48;

		/** Strands are different ones if they are this many widths apart along the filament. */
		private static final double APART = 4;

		/** @return the shape of a contour whose line is {@code width} pixels wide */
		static Shape of(final Polyline contour, final double width) {
			final Polyline points = contour.divided(LINKS);
			return new Shape(points, isKnotted(contour.resampled(width / 2), width),
				turning(points));
		}

		double extension() {
			return points.first().distanceTo(points.last()) / points.length();
		}

		double tipWay(final Shape before) {
			return points.last().distanceTo(before.points.last());
		}

		double meanWay(final Shape before) {
			double sum = 0;
			for (int i = 0; i <= LINKS; i++)
				sum += points.point(i).distanceTo(before.points.point(i));
			return sum / (LINKS + 1);
		}

		private static double turning(final Polyline p) {
			double sum = 0;
			for (int i = 1; i < p.size() - 1; i++) {
				final double ax = p.x(i) - p.x(i - 1), ay = p.y(i) - p.y(i - 1);
				final double bx = p.x(i + 1) - p.x(i), by = p.y(i + 1) - p.y(i);
				sum += Math.abs(Math.atan2(ax * by - ay * bx, ax * bx + ay * by));
			}
			return sum / (2 * Math.PI);
		}

		/** Points are half a width apart, so that strands that cross come near. */
		private static boolean isKnotted(final Polyline p, final double width) {
			for (int i = 0; i < p.size(); i++)
				for (int j = i + 1; j < p.size(); j++)
					if (p.arc(j) - p.arc(i) > APART * width
						&& p.point(i).distanceTo(p.point(j)) < width)
						return true;
			return false;
		}
	}
}
