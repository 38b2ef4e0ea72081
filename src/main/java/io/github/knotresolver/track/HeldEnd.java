
package io.github.knotresolver.track;

import java.util.ArrayList;
import java.util.List;
import java.util.function.DoubleFunction;

import io.github.knotresolver.fit.Chain;
import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.geometry.Polyline;

/**
 * A glider whose leading end is held, while all else is pushed on along its track: the piece
 * before the end buckles, or bends farther where it is bent already. So knots and rings are wound
 * (L. Bourdieu et al., Phys. Rev. Lett. 75 (1995) 176-179, doi:10.1103/PhysRevLett.75.176).
 */
final class HeldEnd {

	/** Lengths of the pieces that may buckle: shorter, as usual, longer (shares of the usual one). */
	private static final double[] PIECES = {0.6, 1, 1.7};

	private HeldEnd() {
	}

	/**
	 * The shapes that a filament may have after it slid, while one of its ends stayed where it is.
	 *
	 * @param chain the filament
	 * @param by how far it slides towards its last point, in pixels; negative towards its first
	 * @return a few chains of the same length, in a fixed order; empty if none is possible
	 */
	static List<Chain> shapes(final Chain chain, final double by) {
		final List<Chain> all = lastHeld(chain, by);
		lastHeld(chain.reversed(), -by).forEach(c -> all.add(c.reversed()));
		return all;
	}

	/**
	 * Whether an end stayed while a filament slid.
	 *
	 * @param before where the end was, in pixels
	 * @param after where it is later
	 * @param by how far the filament slid, in pixels
	 */
	static boolean isHeld(final Point before, final Point after, final double by) {
		return before.distanceTo(after) < SceneTuning.HELD_SHARE * Math.abs(by);
	}

	/** How many links before a held end leave the track, at most a third of all. */
	static int piece(final Chain chain) {
		return Math.min(chain.links() / 3,
			(int) Math.ceil(SceneTuning.HELD_PIECE / chain.linkLength()));
	}

	private static List<Chain> lastHeld(final Chain chain, final double by) {
		final List<Chain> all = new ArrayList<>();
		final Polyline before = chain.polyline(), slid = chain.slid(by).polyline();
		for (final double share : PIECES) {
			final int k = (int) Math.rint(share * SceneTuning.HELD_PIECE / chain.linkLength());
			final double wanted = k * chain.linkLength();
			final int joint = chain.links() - k;
			if (joint < 1 || wanted - by < 2 * chain.linkLength()
				|| slid.point(joint).distanceTo(before.last()) > wanted)
				continue;
			final Point[] rest = rest(before, chain.length() - wanted + by, k);
			for (final Point[] bent : bent(rest, wanted))
				all.add(joined(slid, joint, bent, chain));
		}
		return all;
	}

	/** Points along a curve from a place to its end, k + 1 of them. */
	private static Point[] rest(final Polyline curve, final double from, final int k) {
		final Point[] rest = new Point[k + 1];
		for (int i = 0; i <= k; i++)
			rest[i] = curve.at(from + i * (curve.length() - from) / k);
		return rest;
	}

	/** A piece as long as wanted between the same ends: bent farther as it is, or to either side. */
	private static List<Point[]> bent(final Point[] rest, final double wanted) {
		final List<Point[]> all = new ArrayList<>();
		final double length = length(rest);
		add(all, s -> stretched(rest, s), length < wanted ? 1 : 0,
			length < wanted ? SceneTuning.HELD_STRETCH : 1, wanted);
		if (length < wanted)
			for (final int side : new int[]{1, -1})
				add(all, a -> bulged(rest, side * a), 0, wanted, wanted);
		return all;
	}

	/** The member of a family, longer from low to high, that is as long as wanted, if there is one. */
	private static void add(final List<Point[]> all, final DoubleFunction<Point[]> family,
		final double low, final double high, final double wanted) {
		if (length(family.apply(low)) > wanted || length(family.apply(high)) < wanted)
			return;
		double from = low, to = high;
		for (int i = 0; i < SceneTuning.HELD_HALVINGS; i++) {
			final double middle = 0.5 * (from + to);
			if (length(family.apply(middle)) < wanted)
				from = middle;
			else
				to = middle;
		}
		all.add(family.apply(0.5 * (from + to)));
	}

	private static Point[] stretched(final Point[] rest, final double s) {
		final int k = rest.length - 1;
		final Point[] next = new Point[k + 1];
		for (int i = 0; i <= k; i++) {
			final double x = rest[0].x() + (rest[k].x() - rest[0].x()) * i / k;
			final double y = rest[0].y() + (rest[k].y() - rest[0].y()) * i / k;
			next[i] = new Point(x + s * (rest[i].x() - x), y + s * (rest[i].y() - y));
		}
		return next;
	}

	private static Point[] bulged(final Point[] rest, final double by) {
		final int k = rest.length - 1;
		final Point[] next = rest.clone();
		for (int i = 1; i < k; i++) {
			final double dx = rest[i + 1].x() - rest[i - 1].x(),
				dy = rest[i + 1].y() - rest[i - 1].y();
			final double sine = Math.sin(Math.PI * i / k);
			final double out = by * sine * sine / Math.max(1e-9, Math.hypot(dx, dy));
			next[i] = new Point(rest[i].x() - out * dy, rest[i].y() + out * dx);
		}
		return next;
	}

	private static double length(final Point[] points) {
		double sum = 0;
		for (int i = 1; i < points.length; i++)
			sum += points[i - 1].distanceTo(points[i]);
		return sum;
	}

	private static Chain joined(final Polyline slid, final int joint, final Point[] bent,
		final Chain chain) {
		final List<Point> points = new ArrayList<>();
		for (int i = 0; i < joint; i++)
			points.add(slid.point(i));
		points.addAll(List.of(bent));
		return Chain.along(Polyline.of(points), chain.links(), chain.length());
	}
}
