
package io.github.knotresolver.fit;

import org.apache.commons.math3.analysis.interpolation.SplineInterpolator;
import org.apache.commons.math3.analysis.polynomials.PolynomialSplineFunction;

import io.github.knotresolver.geometry.Angles;
import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.geometry.Polyline;

/**
 * An inextensible filament: links of equal length, each with its own direction.
 * The total length is {@code links() * linkLength()}, whatever the shape.
 */
public final class Chain {

	private final double x0;
	private final double y0;
	private final double[] theta;
	private final double linkLength;

	Chain(final double x0, final double y0, final double[] theta, final double linkLength) {
		this.x0 = x0;
		this.y0 = y0;
		this.theta = theta;
		this.linkLength = linkLength;
	}

	/**
	 * The chain that follows a curve, scaled to a given length: a curve that is
	 * too short or too long keeps its shape and is stretched along its arc.
	 *
	 * @param curve at least two different points, fixed end first, in pixels
	 * @param links number of links, at least 2
	 * @param length total length of the chain in pixels, above 0
	 * @return the chain, starting at the curve's first point
	 */
	public static Chain along(final Polyline curve, final int links, final double length) {
		final Polyline nodes = curve.divided(links);
		final double[] theta = new double[links];
		for (int i = 0; i < links; i++) {
			final double angle = Math.atan2(nodes.y(i + 1) - nodes.y(i),
				nodes.x(i + 1) - nodes.x(i));
			theta[i] = i == 0 ? angle : Angles.nearest(angle, theta[i - 1]);
		}
		return new Chain(nodes.x(0), nodes.y(0), theta, length / links);
	}

	/**
	 * A curve as one of the chains of a scene: of its own length, with links of about 3 px.
	 *
	 * @param curve at least two different points, in pixels
	 * @param length of the chain in pixels; the curve is scaled to it
	 * @return the chain, with at least 8 links
	 */
	public static Chain inScene(final Polyline curve, final double length) {
		return along(curve, linksInScene(length), length);
	}

	/**
	 * @param length in pixels
	 * @return the number of links of a filament of a scene
	 */
	public static int linksInScene(final double length) {
		return Math.max(FitTuning.FEWEST_LINKS, (int) Math.rint(length / FitTuning.LINK));
	}

	/**
	 * @param links number of links, at least 2
	 * @return the same curve with so many links
	 */
	public Chain divided(final int links) {
		return links == theta.length ? this : along(polyline(), links, length());
	}

	/** @return the number of links */
	public int links() {
		return theta.length;
	}

	/** @return the length of one link in pixels */
	public double linkLength() {
		return linkLength;
	}

	/** @return the length of the filament in pixels */
	public double length() {
		return linkLength * theta.length;
	}

	/** @return the fixed end */
	public Point start() {
		return new Point(x0, y0);
	}

	/**
	 * @param i 0 to {@code links() - 1}
	 * @return the direction of a link in radians, continuous along the chain
	 */
	public double angle(final int i) {
		return theta[i];
	}

	/**
	 * @return the nodes as a polyline of {@code links() + 1} points, in pixels
	 */
	public Polyline polyline() {
		final double[] x = new double[theta.length + 1], y = new double[theta.length + 1];
		nodes(x, y);
		return Polyline.of(x, y);
	}

	/**
	 * The smooth curve that the chain stands for, sampled at about a pixel. The nodes of a
	 * chain that is fitted to a bent line lie outside of the bend, by two thirds of the
	 * sagitta of a link, and the middles of its links inside, by one third: the nodes are
	 * moved back by as much, and joined by a cubic spline. So the length of a contour does
	 * not depend on how bent it is.
	 *
	 * @return the contour in pixels, fixed end first
	 */
	public Polyline contour() {
		final int n = theta.length;
		final double[] x = new double[n + 1], y = new double[n + 1], s = new double[n + 1];
		nodes(x, y);
		for (int i = 0; i <= n; i++)
			s[i] = i * linkLength;
		final PolynomialSplineFunction splineX = spline(s, x), splineY = spline(s, y);
		final int points = Math.max(2, (int) Math.rint(length()) + 1);
		final double[] cx = new double[points], cy = new double[points];
		for (int k = 0; k < points; k++) {
			final double at = Math.min(s[n], s[n] * k / (points - 1));
			cx[k] = splineX.value(at);
			cy[k] = splineY.value(at);
		}
		return Polyline.of(cx, cy);
	}

	private static PolynomialSplineFunction spline(final double[] s, final double[] nodes) {
		final double[] moved = nodes.clone();
		for (int i = 1; i < nodes.length - 1; i++)
			moved[i] += (nodes[i - 1] - 2 * nodes[i] + nodes[i + 1]) / 12;
		return new SplineInterpolator().interpolate(s, moved);
	}

	/** Writes the nodes into the arrays, which hold at least links + 1 values. */
	void nodes(final double[] x, final double[] y) {
		x[0] = x0;
		y[0] = y0;
		for (int i = 0; i < theta.length; i++) {
			x[i + 1] = x[i] + linkLength * Math.cos(theta[i]);
			y[i + 1] = y[i] + linkLength * Math.sin(theta[i]);
		}
	}

	/**
	 * This shape if it went on changing as it did since an earlier one.
	 *
	 * @param earlier an earlier chain with as many links
	 * @param factor 1 for a full step onwards, 0 for none
	 * @return the extrapolated chain
	 */
	public Chain extrapolated(final Chain earlier, final double factor) {
		final double[] next = theta.clone();
		final double turn = Angles.nearest(earlier.theta[0], theta[0]) - earlier.theta[0];
		for (int i = 0; i < next.length; i++)
			next[i] += factor * (theta[i] - earlier.theta[i] - turn);
		return new Chain(x0, y0, next, linkLength);
	}

	/**
	 * The same filament with another length: cut off at the tip, or going on straight there.
	 *
	 * @param length in pixels, above 0
	 * @return a chain with as many links that lies on this one as far as both go
	 */
	public Chain resized(final double length) {
		final int n = theta.length;
		final double h = length / n;
		if (h == linkLength)
			return this;
		final double[] next = new double[n];
		for (int i = 0; i < n; i++) {
			final double at = Math.max(0, Math.min(n - 1, (i + 0.5) * h / linkLength - 0.5));
			final int lower = Math.min(n - 2, (int) at);
			next[i] = theta[lower] + (at - lower) * (theta[lower + 1] - theta[lower]);
		}
		return new Chain(x0, y0, next, h);
	}

	/** @return the tip, in pixels */
	public Point tip() {
		final double[] x = new double[theta.length + 1], y = new double[theta.length + 1];
		nodes(x, y);
		return new Point(x[theta.length], y[theta.length]);
	}

	/**
	 * This shape after the filament has slid along itself: the part beyond a place keeps its
	 * track and goes on along it, what has slid out of it winds up at that place with the
	 * curvature there, and turns the part before. So a filament moves that is pushed towards
	 * its clamped end.
	 *
	 * @param at the place, as a link's number, 0 to {@code links() - 1}
	 * @param by how many links the outer part slides towards the fixed end; negative to slide
	 *          away from it; less than {@code links() - at} in magnitude
	 * @return the chain, starting at the same point
	 */
	public Chain wound(final int at, final int by) {
		final int n = theta.length;
		final double[] next = new double[n];
		final double bend = by > 0 ? curvature(at) * by : theta[at] - theta[at - by];
		for (int i = 0; i < n; i++)
			next[i] = i < at
				? theta[i] - bend
				: i < at + by
					? theta[at] - bend * (1 - (double) (i - at) / by)
					: theta[Math.min(n - 1, i - by)];
		return new Chain(x0, y0, next, linkLength);
	}

	/** Mean change of direction from link to link near a link, in radians. */
	private double curvature(final int at) {
		final int from = Math.max(0, at - FitTuning.NEAR_LINKS),
			to = Math.min(theta.length - 1, at + FitTuning.NEAR_LINKS);
		return (theta[to] - theta[from]) / (to - from);
	}

	/**
	 * This filament if it went on moving, as a whole, as it did since an earlier shape.
	 *
	 * @param earlier an earlier chain with as many links
	 * @return the extrapolated chain
	 */
	public Chain continued(final Chain earlier) {
		final Chain turned = extrapolated(earlier, 1);
		return turned.shifted(x0 - earlier.x0, y0 - earlier.y0);
	}

	/**
	 * This filament after it has slid along its own track; beyond its ends it goes straight
	 * on. So a filament glides.
	 *
	 * @param by how far towards its last point, in pixels; negative towards its first
	 * @return the chain, of the same length
	 */
	public Chain slid(final double by) {
		final int n = theta.length;
		final double[] next = new double[n];
		for (int i = 0; i < n; i++) {
			final double at = Math.max(0, Math.min(n - 1, i + by / linkLength));
			final int low = Math.min((int) at, n - 1), high = Math.min(low + 1, n - 1);
			next[i] = theta[low] + (at - low) * (theta[high] - theta[low]);
		}
		double x = x0, y = y0, left = by;
		for (int i = 0; i < n && left > 0; i++) {
			final double step = i == n - 1 ? left : Math.min(left, linkLength);
			x += step * Math.cos(theta[i]);
			y += step * Math.sin(theta[i]);
			left -= step;
		}
		return new Chain(x + Math.min(0, left) * Math.cos(theta[0]),
			y + Math.min(0, left) * Math.sin(theta[0]), next, linkLength);
	}

	/**
	 * How far a filament has slid along itself.
	 *
	 * @param later a later shape with as many links
	 * @return the mean motion of its points along their links, in pixels
	 */
	public double slide(final Chain later) {
		final int n = theta.length;
		final double[] ax = new double[n + 1], ay = new double[n + 1], bx = new double[n + 1],
			by = new double[n + 1];
		nodes(ax, ay);
		later.nodes(bx, by);
		double sum = 0;
		for (int i = 0; i < n; i++)
			sum += (bx[i] - ax[i]) * Math.cos(later.theta[i])
				+ (by[i] - ay[i]) * Math.sin(later.theta[i]);
		return sum / n;
	}

	/** @return the sum of squared turns from link to link, by the length of a link, in 1/px */
	public double bending() {
		double sum = 0;
		for (int i = 1; i < theta.length; i++)
			sum += (theta[i] - theta[i - 1]) * (theta[i] - theta[i - 1]);
		return sum / linkLength;
	}

	/** @return the same filament from its last point to its first */
	public Chain reversed() {
		final int n = theta.length;
		final double[] x = new double[n + 1], y = new double[n + 1], next = new double[n];
		nodes(x, y);
		for (int i = 0; i < n; i++)
			next[i] = theta[n - 1 - i] + Math.PI;
		return new Chain(x[n], y[n], next, linkLength);
	}

	/**
	 * @param dx columns in pixels
	 * @param dy rows in pixels
	 * @return the chain moved as a whole
	 */
	public Chain shifted(final double dx, final double dy) {
		return new Chain(x0 + dx, y0 + dy, theta, linkLength);
	}

	/** The chain whose last links have other directions, in radians. */
	Chain withTail(final double[] tail) {
		final double[] next = theta.clone();
		System.arraycopy(tail, 0, next, next.length - tail.length, tail.length);
		return new Chain(x0, y0, next, linkLength);
	}

	/**
	 * Mean distance of corresponding nodes: the distance at equal arc length from
	 * the fixed end.
	 *
	 * @param other a chain with as many links
	 * @return the distance in pixels
	 */
	public double distance(final Chain other) {
		final int n = theta.length + 1;
		final double[] ax = new double[n], ay = new double[n], bx = new double[n],
			by = new double[n];
		nodes(ax, ay);
		other.nodes(bx, by);
		double sum = 0;
		for (int i = 0; i < n; i++)
			sum += Math.sqrt((ax[i] - bx[i]) * (ax[i] - bx[i]) + (ay[i] - by[i]) * (ay[i] - by[i]));
		return sum / n;
	}

	/**
	 * @param other a chain with as many links
	 * @return the largest distance of corresponding nodes, in pixels
	 */
	public double farthest(final Chain other) {
		final int n = theta.length + 1;
		final double[] ax = new double[n], ay = new double[n], bx = new double[n],
			by = new double[n];
		nodes(ax, ay);
		other.nodes(bx, by);
		double most = 0;
		for (int i = 0; i < n; i++)
			most = Math.max(most, Math.hypot(ax[i] - bx[i], ay[i] - by[i]));
		return most;
	}

	/**
	 * O(links of both).
	 *
	 * @param other another chain
	 * @param distance in pixels
	 * @return whether some node of one lies nearer than that, and half a link of each, to one of
	 *         the other
	 */
	public boolean comesNear(final Chain other, final double distance) {
		final double[] ax = new double[theta.length + 1], ay = new double[theta.length + 1];
		final double[] bx = new double[other.theta.length + 1], by = new double[bx.length];
		nodes(ax, ay);
		other.nodes(bx, by);
		final double far = distance + 0.5 * (linkLength + other.linkLength);
		for (int i = 0; i < ax.length; i++)
			for (int k = 0; k < bx.length; k++)
				if ((ax[i] - bx[k]) * (ax[i] - bx[k]) + (ay[i] - by[k]) * (ay[i] - by[k]) < far
					* far)
					return true;
		return false;
	}

	/**
	 * Mean absolute difference of the directions at equal arc length. Directions are
	 * continuous along a chain, so that a loop that is run the other way round counts
	 * with its full turn even if it covers the same pixels.
	 *
	 * @param other a chain with as many links
	 * @return the difference in radians
	 */
	public double turn(final Chain other) {
		final double full = Angles.nearest(other.theta[0], theta[0]) - other.theta[0];
		double sum = 0;
		for (int i = 0; i < theta.length; i++)
			sum += Math.abs(theta[i] - other.theta[i] - full);
		return sum / theta.length;
	}

	/**
	 * @param other a chain with as many links
	 * @return the mean squared difference of the directions at equal arc length, in radians
	 *         squared, but for full turns of the whole
	 */
	public double squaredTurn(final Chain other) {
		return squaredTurn(other, 0, theta.length) / theta.length;
	}

	/**
	 * @param other a chain with as many links
	 * @param from index of a link
	 * @param to index behind the last one
	 * @return the sum of the squared differences of the directions of these links, in radians
	 *         squared, but for full turns of the whole
	 */
	public double squaredTurn(final Chain other, final int from, final int to) {
		final int middle = theta.length / 2;
		final double full = Angles.nearest(other.theta[middle], theta[middle])
			- other.theta[middle];
		double sum = 0;
		for (int i = from; i < to; i++) {
			final double d = theta[i] - other.theta[i] - full;
			sum += d * d;
		}
		return sum;
	}

	/**
	 * The chain moved by a step of the solver: x0, y0, angles and link length.
	 */
	Chain moved(final double[] step, final double scale, final double linkStep) {
		final double[] next = new double[theta.length];
		for (int i = 0; i < next.length; i++)
			next[i] = theta[i] + scale * step[i + 2];
		return new Chain(x0 + scale * step[0], y0 + scale * step[1], next, linkLength + linkStep);
	}
}
