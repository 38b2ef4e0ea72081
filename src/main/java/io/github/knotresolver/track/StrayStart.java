package io.github.knotresolver.track;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.stream.IntStream;

import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.geometry.RobustStatistics;
import io.github.knotresolver.image.LineAppearance;
import io.github.knotresolver.model.Observation;

/**
 * Whether contours begin where the filament is clamped. A clamp stays, jitters or goes with the
 * stage; a contour that begins far from where the others do, though the filament did not go there
 * with it, was drawn to a speck beside the clamp, or cut short of it.
 */
final class StrayStart {

	private static final String WHY = "Doubtful: the contour begins far from where the filament is clamped in other frames.";

	/** Points at which the way of a contour's beginning is taken. */
	private static final int SAMPLES = 8;

	private StrayStart() {
	}

	/**
	 * Takes the confidence off contours that begin elsewhere; off all, if that many do that which of
	 * the places is the clamp's is a guess. O(frames log frames + frames * length).
	 *
	 * @param frames of one clamped filament, in order of time
	 * @param sigma of the line in pixels
	 * @return the same contours, none of which is believed if it begins elsewhere
	 */
	static List<Observation> doubted(final List<Observation> frames, final double sigma) {
		final int[] seen = IntStream.range(0, frames.size())
			.filter(t -> frames.get(t).contour().isPresent()).toArray();
		if (seen.length < TrackTuning.STRAY_FEWEST)
			return frames;
		final List<Point> starts = IntStream.of(seen).mapToObj(t -> contour(frames, t).first())
			.toList();
		final Point middle = RobustStatistics.median(starts);
		final double[] off = starts.stream().mapToDouble(middle::distanceTo).toArray();
		final double usual = Math.max(LineAppearance.FULL_WIDTH * sigma,
			TrackTuning.STRAY * RobustStatistics.median(off));
		final int[] stray = IntStream.range(0, seen.length)
			.filter(k -> off[k] > usual && !isCarried(frames, seen, off, usual, k))
			.map(k -> seen[k]).toArray();
		final List<Observation> doubted = new ArrayList<>(frames);
		for (final int t : stray.length < TrackTuning.STRAY_OFTEN * seen.length ? stray : seen)
			doubted.set(t, frames.get(t).doubted(TrackTuning.TURNED, WHY));
		return doubted;
	}

	/**
	 * Whether the filament near its start went as that did, since the nearest frame that begins as
	 * usual.
	 */
	private static boolean isCarried(final List<Observation> frames, final int[] seen,
		final double[] off, final double usual, final int k) {
		final int near = IntStream.range(0, seen.length).filter(i -> off[i] <= usual).boxed()
			.min(Comparator.comparingInt(i -> Math.abs(seen[i] - seen[k]))).orElseThrow();
		final Polyline there = contour(frames, seen[near]), here = contour(frames, seen[k]);
		final List<Point> went = IntStream.rangeClosed(0, SAMPLES)
			.mapToObj(i -> went(there, here, TrackTuning.NEAR_START * i / SAMPLES)).toList();
		return RobustStatistics.median(went).distanceTo(went.get(0)) < TrackTuning.CARRIED
			* there.first().distanceTo(here.first());
	}

	/** How far a point at a share of the length went. */
	private static Point went(final Polyline from, final Polyline to, final double share) {
		final Point a = from.at(share * from.length()), b = to.at(share * to.length());
		return new Point(b.x() - a.x(), b.y() - a.y());
	}

	private static Polyline contour(final List<Observation> frames, final int t) {
		return frames.get(t).contour().orElseThrow();
	}
}
