
package io.github.knotresolver.geometry;

import java.util.Arrays;
import java.util.List;

/**
 * An immutable ordered chain of points, in pixels. A contour of a filament is a
 * polyline whose first point is the fixed end and whose last is the free tip.
 * <p>
 * All operations are linear in the number of points unless stated otherwise.
 */
public final class Polyline {

	/** Steps shorter than this (pixels) are taken to be the same point. */
	private static final double SAME_POINT = 1e-9;

	private final double[] x;
	private final double[] y;
	private final double[] arc;

	private Polyline(final double[] x, final double[] y) {
		this.x = x;
		this.y = y;
		this.arc = new double[x.length];
		for (int i = 1; i < x.length; i++)
			arc[i] = arc[i - 1] + Math.hypot(x[i] - x[i - 1], y[i] - y[i - 1]);
	}

	/**
	 * A polyline through the given coordinates; the arrays are copied.
	 *
	 * @param x columns in pixels, at least one
	 * @param y rows in pixels, as many as {@code x}
	 * @return the polyline
	 * @throws IllegalArgumentException if there is no point, the lengths differ
	 *           or a coordinate is not finite
	 */
	public static Polyline of(final double[] x, final double[] y) {
		if (x.length == 0 || x.length != y.length)
			throw new IllegalArgumentException(
				"A polyline needs as many x as y, at least one each, but has " + x.length + " and "
					+ y.length + ".");
		for (int i = 0; i < x.length; i++)
			if (!Double.isFinite(x[i]) || !Double.isFinite(y[i]))
				throw new IllegalArgumentException(
					"Point " + i + " of the polyline is not finite: " + x[i] + "," + y[i] + ".");
		return new Polyline(x.clone(), y.clone());
	}

	/**
	 * A polyline through the given points.
	 *
	 * @param points at least one point
	 * @return the polyline
	 */
	public static Polyline of(final List<Point> points) {
		return of(points.stream().mapToDouble(Point::x).toArray(),
			points.stream().mapToDouble(Point::y).toArray());
	}

	/** @return the number of points, at least 1 */
	public int size() {
		return x.length;
	}

	/**
	 * @param i index, 0 to {@code size() - 1}
	 * @return column of the point, in pixels
	 */
	public double x(final int i) {
		return x[i];
	}

	/**
	 * @param i index, 0 to {@code size() - 1}
	 * @return row of the point, in pixels
	 */
	public double y(final int i) {
		return y[i];
	}

	/** @return a copy of the columns */
	public double[] xs() {
		return x.clone();
	}

	/** @return a copy of the rows */
	public double[] ys() {
		return y.clone();
	}

	/**
	 * @param i index, 0 to {@code size() - 1}
	 * @return the point
	 */
	public Point point(final int i) {
		return new Point(x[i], y[i]);
	}

	/** @return the first point: of a contour, the fixed end */
	public Point first() {
		return point(0);
	}

	/** @return the last point: of a contour, the free tip */
	public Point last() {
		return point(size() - 1);
	}

	/** @return the length in pixels */
	public double length() {
		return arc[arc.length - 1];
	}

	/**
	 * @param i index, 0 to {@code size() - 1}
	 * @return the arc length from the first point to point {@code i}, in pixels
	 */
	public double arc(final int i) {
		return arc[i];
	}

	/**
	 * O(n).
	 *
	 * @param place anywhere
	 * @return its distance to the nearest point of the curve, between the vertices, too
	 */
	public double distanceTo(final Point place) {
		double nearest = place.distanceTo(first());
		for (int i = 1; i < size(); i++)
			nearest = Math.min(nearest, distance(point(i - 1), point(i), place));
		return nearest;
	}

	private static double distance(final Point a, final Point b, final Point p) {
		final double dx = b.x() - a.x(), dy = b.y() - a.y(), square = dx * dx + dy * dy;
		final double along = square == 0
			? 0
			: Math.max(0, Math.min(1, ((p.x() - a.x()) * dx + (p.y() - a.y()) * dy) / square));
		return p.distanceTo(new Point(a.x() + along * dx, a.y() + along * dy));
	}

	/** @return the same points from last to first */
	public Polyline reversed() {
		final int n = size();
		final double[] rx = new double[n], ry = new double[n];
		for (int i = 0; i < n; i++) {
			rx[i] = x[n - 1 - i];
			ry[i] = y[n - 1 - i];
		}
		return new Polyline(rx, ry);
	}

	/**
	 * The point at an arc length from the first point, by linear interpolation.
	 * O(log n).
	 *
	 * @param s arc length in pixels; clamped to 0..{@link #length()}
	 * @return the point
	 */
	public Point at(final double s) {
		if (s <= 0 || size() == 1)
			return first();
		if (s >= length())
			return last();
		int hi = Arrays.binarySearch(arc, s);
		if (hi >= 0)
			return point(hi);
		hi = -hi - 1;
		final double step = arc[hi] - arc[hi - 1];
		final double f = step > SAME_POINT ? (s - arc[hi - 1]) / step : 0;
		return new Point(x[hi - 1] + f * (x[hi] - x[hi - 1]), y[hi - 1] + f * (y[hi] - y[hi - 1]));
	}

	/**
	 * The same curve with nearly {@code step} pixels of arc length between
	 * neighbours: both end points are kept, the step is stretched to fit.
	 *
	 * @param step wanted spacing in pixels, above 0
	 * @return the resampled curve, at least two points; a polyline of zero length
	 *         is returned as its first point
	 */
	public Polyline resampled(final double step) {
		if (!(step > 0))
			throw new IllegalArgumentException(
				"The resampling step must be above 0 pixels, but is " + step + ".");
		return length() <= SAME_POINT
			? new Polyline(new double[]{x[0]}, new double[]{y[0]})
			: divided(Math.max(1, (int) Math.rint(length() / step)));
	}

	/**
	 * The same curve as links of equal arc length.
	 *
	 * @param links number of links, at least 1
	 * @return a polyline of {@code links + 1} points
	 */
	public Polyline divided(final int links) {
		final double[] rx = new double[links + 1], ry = new double[links + 1];
		int k = 1;
		for (int i = 0; i <= links; i++) {
			final double s = length() * i / links;
			while (k < size() - 1 && arc[k] < s)
				k++;
			final int lo = Math.max(0, k - 1);
			final int hi = Math.min(k, size() - 1);
			final double width = arc[hi] - arc[lo];
			final double f = width > SAME_POINT
				? Math.min(1, Math.max(0, (s - arc[lo]) / width))
				: 0;
			rx[i] = x[lo] + f * (x[hi] - x[lo]);
			ry[i] = y[lo] + f * (y[hi] - y[lo]);
		}
		rx[links] = x[size() - 1];
		ry[links] = y[size() - 1];
		return new Polyline(rx, ry);
	}

	/**
	 * The points at every {@code step} pixels of arc length from the first, so that
	 * points of equal index in two curves are at equal arc length. What is left of the
	 * curve after the last whole step is not represented.
	 *
	 * @param step spacing in pixels, above 0
	 * @return the points, at least one
	 */
	public Polyline every(final double step) {
		if (!(step > 0))
			throw new IllegalArgumentException(
				"The sampling step must be above 0 pixels, but is " + step + ".");
		final int n = (int) Math.floor(length() / step) + 1;
		return n > 1
			? head((n - 1) * step).divided(n - 1)
			: new Polyline(new double[]{x[0]}, new double[]{y[0]});
	}

	/**
	 * The part of the curve up to an arc length.
	 *
	 * @param s arc length in pixels; the whole curve if it is not shorter
	 * @return the first {@code s} pixels of the curve
	 */
	public Polyline head(final double s) {
		if (s >= length())
			return this;
		int n = 1;
		while (n < size() && arc[n] < s)
			n++;
		final Point end = at(s);
		final double[] hx = Arrays.copyOf(x, n + 1), hy = Arrays.copyOf(y, n + 1);
		hx[n] = end.x();
		hy[n] = end.y();
		return new Polyline(hx, hy);
	}

	@Override
	public boolean equals(final Object o) {
		return o instanceof Polyline p && Arrays.equals(x, p.x) && Arrays.equals(y, p.y);
	}

	@Override
	public int hashCode() {
		return 31 * Arrays.hashCode(x) + Arrays.hashCode(y);
	}

	@Override
	public String toString() {
		return "Polyline of " + size() + " points, " + length() + " px, from " + first() + " to "
			+ last();
	}
}
