
package io.github.knotresolver.track;

import java.util.List;
import java.util.stream.IntStream;

import io.github.knotresolver.fit.Chain;
import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.geometry.RobustStatistics;
import io.github.knotresolver.model.Observation;
import io.github.knotresolver.model.Settings.AnchorChoice;

/**
 * Which end of a filament comes first: the clamped one if there is one; the trailing one of a
 * filament that glides along its own track; of one that is carried about while it beats, the
 * end that moves less and more smoothly, as a clamp that is carried.
 *
 * @param clamped whether one end is held
 * @param reversed whether the last point comes first
 * @param slid how far the filament has slid towards its leading end, in pixels
 * @param roams whether both ends were seen to go far
 * @param alike whether its ends move so much alike that which one comes first is in doubt
 */
record FilamentEnds(boolean clamped, boolean reversed, double slid, boolean roams, boolean alike) {

	private static final String WHY = "Doubtful: both ends move alike, so which one comes first is a guess.";

	/**
	 * The ends by the longest time over which the filament is seen clearly, if that is long
	 * enough: what happens while it is lost must not decide. Otherwise by all frames.
	 *
	 * @param chains a filament in all its frames, in order of time
	 * @param clear for each whether all light around it is explained
	 * @param anchor whether an end is held, if that is told
	 */
	static FilamentEnds of(final List<Chain> chains, final boolean[] clear,
		final AnchorChoice anchor) {
		int from = 0, best = 0, bestFrom = 0, last = -1;
		for (int t = 0; t < clear.length; t++)
			if (clear[t]) {
				if (last < 0 || t - last > TrackTuning.ENDS_GAP + 1)
					from = t;
				last = t;
				if (t - from + 1 > best) {
					best = t - from + 1;
					bestFrom = from;
				}
			}
		if (best < TrackTuning.ENDS_FEWEST || best < TrackTuning.ENDS_ENOUGH * clear.length) {
			final FilamentEnds doubtful = of(chains, anchor);
			return new FilamentEnds(doubtful.clamped, doubtful.reversed, doubtful.slid, false,
				doubtful.alike);
		}
		return of(chains.subList(bestFrom, bestFrom + best), anchor);
	}

	/**
	 * @param chains a filament in all its frames, in order of time
	 * @param anchor whether an end is held, if that is told
	 */
	static FilamentEnds of(final List<Chain> chains, final AnchorChoice anchor) {
		final int n = chains.size();
		double slid = 0;
		for (int t = 0; t + 1 < n; t++)
			slid += chains.get(t).slide(chains.get(t + 1));
		final double f = step(chains, false, 1), l = step(chains, true, 1);
		final double less = Math.min(f, l), more = Math.max(f, l);
		final boolean stillIsLast = l < f;
		final double held = spread(chains, stillIsLast), loose = spread(chains, !stillIsLast);
		final int lag = lag(n - 1, more);
		final boolean clamped = switch (anchor) {
			case AUTO -> step(chains, stillIsLast, lag) < TrackTuning.HELD_SHARE
				* step(chains, !stillIsLast, lag)
				&& (held < TrackTuning.HELD_STAYS * loose
					|| less < TrackTuning.HELD_STILL && held < Math.max(TrackTuning.HELD_PLACE,
						TrackTuning.HELD_PLACE_SHARE * loose));
			case CLAMPED -> true;
			case FREE -> false;
		};
		final boolean glides = !clamped && glides(chains, slid);
		final double a = f * unsteadiness(chains, false), b = l * unsteadiness(chains, true);
		final boolean lastFirst = !glides
			&& Math.min(a, b) < TrackTuning.ENDS_ALIKE * Math.max(a, b) ? b < a : slid < 0;
		return new FilamentEnds(clamped, clamped ? stillIsLast : lastFirst, Math.abs(slid),
			!clamped && Math.min(held, loose) > TrackTuning.ROAMS,
			!clamped && !glides && Math.min(a, b) > TrackTuning.ENDS_DOUBT * Math.max(a, b));
	}

	/** The same contours, none of which is believed if the ends may be exchanged. */
	List<Observation> doubted(final List<Observation> frames) {
		return alike
			? frames.stream().map(o -> o.doubted(TrackTuning.TURNED, WHY)).toList()
			: frames;
	}

	/** Whether a filament follows its own track. O(frames links²). */
	private static boolean glides(final List<Chain> chains, final double slid) {
		final int steps = chains.size() - 1;
		if (steps < 1 || slid == 0)
			return false;
		final int lag = lag(steps, Math.abs(slid) / steps);
		final double[] off = new double[steps + 1 - lag];
		for (int t = 0; t < off.length; t++)
			off[t] = offTrack(chains.get(t).polyline(), chains.get(t + lag).polyline());
		return median(off) < TrackTuning.OFF_TRACK * lag * Math.abs(slid) / steps;
	}

	/**
	 * After how many steps a motion is no longer drowned in noise.
	 *
	 * @param most how many steps there are
	 * @param step how far one goes, in pixels
	 */
	private static int lag(final int most, final double step) {
		return (int) Math.max(1, Math.min(most, Math.ceil(TrackTuning.GLIDES_FAR / step)));
	}

	/** How far an end goes in so many frames, in pixels: median. */
	private static double step(final List<Chain> chains, final boolean last, final int lag) {
		final List<Point> at = ends(chains, last);
		return median(IntStream.range(0, Math.max(0, at.size() - lag))
			.mapToDouble(t -> at.get(t).distanceTo(at.get(t + lag))).toArray());
	}

	/** Median distance of the nodes of a later shape from an earlier one. */
	private static double offTrack(final Polyline before, final Polyline after) {
		final double[] distances = new double[after.size()];
		for (int i = 0; i < distances.length; i++) {
			double nearest = Double.POSITIVE_INFINITY;
			for (int k = 0; k + 1 < before.size(); k++)
				nearest = Math.min(nearest,
					after.point(i).distanceToSegment(before.point(k), before.point(k + 1)));
			distances[i] = nearest;
		}
		return median(distances);
	}

	/** Median change of an end's step from frame to frame, in pixels. */
	private static double unsteadiness(final List<Chain> chains, final boolean last) {
		final List<Point> at = ends(chains, last);
		final double[] changes = new double[Math.max(0, at.size() - 2)];
		for (int t = 0; t < changes.length; t++) {
			final Point a = at.get(t), b = at.get(t + 1), c = at.get(t + 2);
			changes[t] = Math.hypot(a.x() - 2 * b.x() + c.x(), a.y() - 2 * b.y() + c.y());
		}
		return median(changes);
	}

	private static List<Point> ends(final List<Chain> chains, final boolean last) {
		return chains.stream().map(c -> last ? c.polyline().last() : c.start()).toList();
	}

	/** The median place of an end, in pixels. */
	static Point place(final List<Chain> chains, final boolean last) {
		return RobustStatistics.upperMedian(ends(chains, last));
	}

	/** Median distance of an end from its median place. */
	private static double spread(final List<Chain> chains, final boolean last) {
		final List<Point> ends = ends(chains, last);
		final Point middle = place(chains, last);
		return median(ends.stream().mapToDouble(middle::distanceTo).toArray());
	}

	private static double median(final double[] values) {
		return RobustStatistics.upperMedian(values, 0);
	}
}
