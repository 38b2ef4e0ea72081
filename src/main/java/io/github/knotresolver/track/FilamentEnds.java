
package io.github.knotresolver.track;

import java.util.Arrays;
import java.util.List;

import io.github.knotresolver.fit.Chain;
import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.model.AnchorChoice;

/**
 * Which end of a filament comes first: the clamped one if there is one, otherwise the one
 * that trails.
 *
 * @param clamped whether one end is held
 * @param reversed whether the last point comes first
 * @param slid how far the filament has slid towards its leading end over the movie, in pixels
 */
record FilamentEnds(boolean clamped, boolean reversed, double slid) {

	/** A clamped end moves by less than this share of what the other end moves, ... */
	private static final double STILL_SHARE = 0.4;

	/** ... and by less than this (pixels) from frame to frame. */
	private static final double STILL = 0.7;

	/**
	 * A clamped end stays this near (pixels, median) to its place; if all drifts, nearer than
	 * this share of what the other end does.
	 */
	private static final double PLACE = 4, PLACE_SHARE = 0.5;

	/**
	 * @param chains a filament in all its frames, in order of time
	 * @param anchor whether an end is held, if that is told
	 */
	static FilamentEnds of(final List<Chain> chains, final AnchorChoice anchor) {
		final int n = chains.size();
		final double[] first = new double[Math.max(0, n - 1)], last = new double[first.length];
		double slid = 0;
		for (int t = 0; t + 1 < n; t++) {
			final Polyline a = chains.get(t).polyline(), b = chains.get(t + 1).polyline();
			first[t] = a.first().distanceTo(b.first());
			last[t] = a.last().distanceTo(b.last());
			slid += chains.get(t).slide(chains.get(t + 1));
		}
		final double f = median(first), l = median(last);
		final double less = Math.min(f, l), more = Math.max(f, l);
		final boolean stillIsLast = l < f;
		final double held = spread(chains, stillIsLast), loose = spread(chains, !stillIsLast);
		final boolean clamped = switch (anchor) {
			case AUTO -> less < STILL && less < STILL_SHARE * more
				&& held < Math.max(PLACE, PLACE_SHARE * loose);
			case CLAMPED -> true;
			case FREE -> false;
		};
		return new FilamentEnds(clamped, clamped ? stillIsLast : slid < 0, Math.abs(slid));
	}

	private static List<Point> ends(final List<Chain> chains, final boolean last) {
		return chains.stream().map(c -> last ? c.polyline().last() : c.start()).toList();
	}

	/** The median place of an end, in pixels. */
	static Point place(final List<Chain> chains, final boolean last) {
		final List<Point> ends = ends(chains, last);
		return new Point(median(ends.stream().mapToDouble(Point::x).toArray()),
			median(ends.stream().mapToDouble(Point::y).toArray()));
	}

	/** Median distance of an end from its median place. */
	private static double spread(final List<Chain> chains, final boolean last) {
		final List<Point> ends = ends(chains, last);
		final Point middle = place(chains, last);
		return median(ends.stream().mapToDouble(middle::distanceTo).toArray());
	}

	private static double median(final double[] values) {
		final double[] sorted = values.clone();
		Arrays.sort(sorted);
		return sorted.length == 0 ? 0 : sorted[sorted.length / 2];
	}
}
