package io.github.knotresolver.fit;

import java.util.ArrayList;
import java.util.List;

import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.geometry.Polyline;

/**
 * Turns a contour that a skeleton proposes into a chain of the known length. A
 * skeleton ends about half a line's width before the filament does: what is
 * missing is added straight on at the tip, up to a limit, and the rest by
 * stretching; what is too much is cut off at the tip.
 */
public final class StartMaker {

	private StartMaker() {
	}

	/**
	 * @param contour at least two points, fixed end first, in pixels
	 * @param clamp the fixed end, which becomes the first point if it is near
	 * @param links number of links
	 * @param length length of the chain in pixels
	 * @return the chain
	 */
	public static Chain start(final Polyline contour, final Point clamp, final int links,
		final double length) {
		return Chain.along(fitted(from(contour, clamp), length), links, length);
	}

	/**
	 * The same for a filament that leaves the picture where the contour ends: all that is
	 * missing is added straight on.
	 *
	 * @param contour at least two points, fixed end first, in pixels
	 * @param clamp the fixed end, which becomes the first point if it is near
	 * @param links number of links
	 * @param length length of the chain in pixels
	 * @return the chain
	 */
	public static Chain leaving(final Polyline contour, final Point clamp, final int links,
		final double length) {
		final Polyline inside = from(contour, clamp);
		final double missing = length - inside.length();
		return Chain.along(missing <= 0 ? inside.head(length) : extended(inside, missing), links,
			length);
	}

	/** The contour, beginning at the clamp. */
	private static Polyline from(final Polyline contour, final Point clamp) {
		final List<Point> points = new ArrayList<>();
		points.add(clamp);
		for (int i = 0; i < contour.size(); i++)
			if (points.size() > 1 || contour.point(i).distanceTo(clamp) > 1)
				points.add(contour.point(i));
		if (points.size() < 2)
			points.add(new Point(clamp.x() + 1, clamp.y()));
		return Polyline.of(points);
	}

	private static Polyline fitted(final Polyline contour, final double length) {
		final double missing = length - contour.length();
		if (missing <= 0)
			return contour.head(length);
		return extended(contour, Math.min(missing, FitTuning.EXTENSION));
	}

	/**
	 * The curve with a straight piece added at the tip.
	 *
	 * @param curve at least two points
	 * @param by length of the piece in pixels
	 * @return the longer curve
	 */
	static Polyline extended(final Polyline curve, final double by) {
		final Point back = curve.at(curve.length() - FitTuning.TIP_DIRECTION);
		final Point tip = curve.last();
		final double base = Math.max(1e-9, back.distanceTo(tip));
		final List<Point> points = new ArrayList<>();
		for (int i = 0; i < curve.size(); i++)
			points.add(curve.point(i));
		points.add(new Point(tip.x() + by * (tip.x() - back.x()) / base,
			tip.y() + by * (tip.y() - back.y()) / base));
		return Polyline.of(points);
	}
}
