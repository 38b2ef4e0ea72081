package io.github.knotresolver.track;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;

import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.progress.Progress;

/**
 * Links the free ends of the skeletons of all frames over time. A path takes at most one
 * end of a frame and gathers its votes; each step costs the more, the farther it goes, so
 * that an end that drifts, jitters or jumps once gathers nearly as much as one that stays,
 * and one that sweeps through the picture, as a tip does, gathers little. Found exactly by
 * dynamic programming over pairs of ends, O(ends times ends within {@value TrackTuning#END_MEMORY}).
 */
final class EndPaths {

	private EndPaths() {
	}

	/**
	 * A free end of a skeleton.
	 *
	 * @param frame index of the frame
	 * @param at in pixels
	 * @param outward direction in which the skeleton ends, in radians
	 * @param vote how much its object looks like the filament, above 0
	 */
	record End(int frame, Point at, double outward, double vote) {

		/** A place farther out. */
		Point beyond(final double by) {
			return new Point(at.x() + by * Math.cos(outward), at.y() + by * Math.sin(outward));
		}

		/** The same with so many times its vote. */
		private End counted(final double times) {
			return new End(frame, at, outward, times * vote);
		}
	}

	/**
	 * Ends of different frames that are the same end of the same object.
	 *
	 * @param ends in order of time, at least one
	 * @param votes what they gather, steps taken off
	 */
	record EndPath(List<End> ends, double votes) {

		/** The end at half of the path. */
		End middle() {
			return ends.get(ends.size() / 2);
		}
	}

	/**
	 * The best path, the best of what it leaves, and so on.
	 *
	 * @param ends in order of time
	 * @param most largest number of paths
	 * @param progress asked whether to stop
	 * @return the paths, no end in two of them
	 */
	static List<EndPath> best(final List<End> ends, final int most, final Progress progress) {
		final List<End> left = new ArrayList<>(ends);
		final List<EndPath> paths = new ArrayList<>();
		while (paths.size() < most && !left.isEmpty()) {
			final Links links = new Links(left, progress);
			final EndPath path = links.through(links.best());
			paths.add(path);
			left.removeAll(path.ends);
		}
		paths.sort(Comparator.comparingDouble(EndPath::votes).reversed());
		return paths;
	}

	/**
	 * The best path that passes a place. Ends near it count more: where the end itself is not seen in
	 * some frames, another one that sweeps through the picture may be seen in more.
	 *
	 * @param ends in order of time
	 * @param place in pixels
	 * @param reach how near it passes in some frame, in pixels
	 * @param progress asked whether to stop
	 * @return the path; empty if no end is near the place in any frame
	 */
	static Optional<EndPath> past(final List<End> ends, final Point place, final double reach,
		final Progress progress) {
		final List<Integer> near = new ArrayList<>();
		final List<End> weighed = new ArrayList<>(ends);
		for (int e = 0; e < ends.size(); e++)
			if (ends.get(e).at.distanceTo(place) <= reach) {
				near.add(e);
				weighed.set(e, ends.get(e).counted(TrackTuning.AT_PLACE));
			}
		if (near.isEmpty())
			return Optional.empty();
		final Links links = new Links(weighed, progress);
		return near.stream().max(Comparator.comparingDouble(links::total)).map(links::through);
	}

	/** The best way to and from each end. */
	private static final class Links {

		private final List<End> ends;
		private final double[] before;
		private final double[] after;
		private final int[] previous;
		private final int[] next;

		Links(final List<End> ends, final Progress progress) {
			this.ends = ends;
			final int n = ends.size();
			before = new double[n];
			after = new double[n];
			previous = new int[n];
			next = new int[n];
			for (int e = 0; e < n; e++) {
				progress.checkCancelled();
				previous[e] = -1;
				for (int f = Math.max(0, e - TrackTuning.END_MEMORY); f < e; f++)
					if (before[f] - price(f, e) > before[e]) {
						before[e] = before[f] - price(f, e);
						previous[e] = f;
					}
				before[e] += ends.get(e).vote;
			}
			for (int e = n - 1; e >= 0; e--) {
				progress.checkCancelled();
				next[e] = -1;
				for (int f = e + 1; f < Math.min(n, e + TrackTuning.END_MEMORY); f++) {
					final double then = after[f] + ends.get(f).vote - price(e, f);
					if (then > after[e]) {
						after[e] = then;
						next[e] = f;
					}
				}
			}
		}

		private double price(final int from, final int to) {
			final End a = ends.get(from), b = ends.get(to);
			return a.frame == b.frame
				? Double.POSITIVE_INFINITY
				: a.at.distanceTo(b.at) / TrackTuning.END_STEP * Math.min(a.vote, b.vote);
		}

		double total(final int e) {
			return before[e] + after[e];
		}

		int best() {
			int best = 0;
			for (int e = 1; e < ends.size(); e++)
				if (total(e) > total(best))
					best = e;
			return best;
		}

		EndPath through(final int end) {
			final List<End> path = new ArrayList<>();
			for (int e = end; e >= 0; e = previous[e])
				path.add(0, ends.get(e));
			for (int e = next[end]; e >= 0; e = next[e])
				path.add(ends.get(e));
			return new EndPath(List.copyOf(path), total(end));
		}
	}
}
