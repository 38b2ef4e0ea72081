package io.github.knotresolver.evaluate;

import java.util.Arrays;

import io.github.knotresolver.contour.DiscreteFrechet;
import io.github.knotresolver.geometry.Crossings;
import io.github.knotresolver.geometry.Polyline;

/** A contour, prepared to be compared with many others. */
final class SceneCurve {

	/** Two curves whose lengths differ by more than this share of the true one, and 10 px, differ. */
	private static final double LENGTH_SHARE = 0.5, LENGTH_PX = 10;
	private static final double STEP = 1, COARSE_STEP = 2;

	private final Polyline fine;
	private final Polyline coarse;
	private final double length;

	/** @param contour a contour longer than 0, in pixels */
	SceneCurve(final Polyline contour) {
		fine = contour.resampled(STEP);
		coarse = contour.resampled(COARSE_STEP);
		length = contour.length();
	}

	/** Which way a result agrees with a true curve. */
	enum Agreement {
		/** Not at all. */
		NONE,
		/** In its direction. */
		FORWARD,
		/** From its last end to its first. */
		BACKWARD,
		/** Both ways: a curve that is as good as a point. */
		BOTH
	}

	/**
	 * @param result a contour to judge
	 * @return whether its Frechet distance to this true one is below 5 px
	 */
	Agreement agreement(final SceneCurve result) {
		if (Math.abs(length - result.length) > LENGTH_SHARE * length + LENGTH_PX
			|| !isNear(fine, result.fine) || !isNear(result.fine, fine))
			return Agreement.NONE;
		final boolean forward = DiscreteFrechet.distance(fine,
			result.fine) < CurveScore.RESOLVED_BELOW;
		final boolean backward = DiscreteFrechet.distance(fine,
			result.fine.reversed()) < CurveScore.RESOLVED_BELOW;
		if (forward)
			return backward ? Agreement.BOTH : Agreement.FORWARD;
		return backward ? Agreement.BACKWARD : Agreement.NONE;
	}

	/** No point is farther from the other curve than its Frechet distance may be. */
	private static boolean isNear(final Polyline a, final Polyline b) {
		return Arrays.stream(CurveScore.nearestDistances(a, b))
			.allMatch(d -> d <= CurveScore.RESOLVED_BELOW);
	}

	/** @return whether the curve crosses itself */
	boolean crossesItself() {
		return !Crossings.of(fine).isEmpty();
	}

	/** @return whether the curves have a point in common */
	boolean crosses(final SceneCurve other) {
		for (int i = 1; i < coarse.size(); i++)
			for (int j = 1; j < other.coarse.size(); j++)
				if (crosses(coarse, i, other.coarse, j))
					return true;
		return false;
	}

	private static boolean crosses(final Polyline p, final int i, final Polyline q, final int j) {
		final double px = p.x(i - 1), py = p.y(i - 1), rx = p.x(i) - px, ry = p.y(i) - py;
		final double qx = q.x(j - 1), qy = q.y(j - 1), sx = q.x(j) - qx, sy = q.y(j) - qy;
		final double d = rx * sy - ry * sx;
		if (Math.abs(d) < 1e-12)
			return false;
		final double t = ((qx - px) * sy - (qy - py) * sx) / d,
			u = ((qx - px) * ry - (qy - py) * rx) / d;
		return t >= 0 && t <= 1 && u >= 0 && u <= 1;
	}
}
