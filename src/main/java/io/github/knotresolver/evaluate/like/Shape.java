package io.github.knotresolver.evaluate.like;

import io.github.knotresolver.geometry.Polyline;

/**
 * One frame's contour as the motion looks at it: points at equal arc length, and
 * what they say together.
 */
final class Shape {

	private static final int LINKS = 48;

	/** Strands are different ones if they are this many widths apart along the filament. */
	private static final double APART = 4;

	private final Polyline points;
	private final boolean knotted;
	private final double turning;

	private Shape(final Polyline points, final boolean knotted, final double turning) {
		this.points = points;
		this.knotted = knotted;
		this.turning = turning;
	}

	/** @return the shape of a contour whose line is {@code width} pixels wide */
	static Shape of(final Polyline contour, final double width) {
		final Polyline points = contour.divided(LINKS);
		return new Shape(points, isKnotted(contour.resampled(width / 2), width), turning(points));
	}

	boolean knotted() {
		return knotted;
	}

	double turning() {
		return turning;
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
