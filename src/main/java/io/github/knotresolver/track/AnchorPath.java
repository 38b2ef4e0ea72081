package io.github.knotresolver.track;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.SortedMap;
import java.util.stream.IntStream;

import io.github.knotresolver.fit.Chain;
import io.github.knotresolver.fit.FitSettings;
import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.geometry.RobustLine;
import io.github.knotresolver.geometry.RobustStatistics;
import io.github.knotresolver.graph.GraphTuning;
import io.github.knotresolver.progress.Progress;
import io.github.knotresolver.track.EndPaths.End;
import io.github.knotresolver.track.EndPaths.EndPath;
import io.github.knotresolver.track.OpenFrames.Seen;

/**
 * Where the clamped end is in every frame, and how strongly it is held there. A clamp that
 * stays has one place; one that drifts, jitters or jumps with the stage has a place in each
 * frame.
 *
 * @param places in pixels, by index of the frame, at least one
 * @param weights price of leaving the place, per square pixel, by index of the frame
 */
record AnchorPath(List<Point> places, double[] weights) {

	/** Weight of a place that is known. */
	private static final double STRONGEST = FitSettings.DEFAULT.clampWeight();

	AnchorPath {
		places = List.copyOf(places);
		if (places.isEmpty() || weights.length != places.size())
			throw new IllegalArgumentException("There are " + places.size() + " places and "
				+ weights.length + " weights; there must be one of each for every frame.");
	}

	/** A clamp that stays. */
	static AnchorPath still(final Point place, final int frames) {
		final double[] weights = new double[frames];
		Arrays.fill(weights, STRONGEST);
		return new AnchorPath(Collections.nCopies(frames, place), weights);
	}

	/** The places along a path of ends, linear in between, the first and last beyond it. */
	static AnchorPath along(final EndPath path, final int frames) {
		return along(path, frames, 0);
	}

	/** The same, so many pixels farther out than the ends. */
	private static AnchorPath along(final EndPath path, final int frames, final double beyond) {
		final List<End> ends = path.ends().stream()
			.map(e -> new End(e.frame(), e.beyond(beyond), e.outward(), e.vote())).toList();
		final Point[] places = new Point[frames];
		int next = 0;
		for (int t = 0; t < frames; t++) {
			while (next < ends.size() && ends.get(next).frame() < t)
				next++;
			places[t] = next == 0
				? ends.get(0).at()
				: next == ends.size()
					? ends.get(next - 1).at()
					: between(ends.get(next - 1), ends.get(next), t);
		}
		return new AnchorPath(List.of(places), new double[frames]);
	}

	private static Point between(final End before, final End after, final int t) {
		final double part = (double) (t - before.frame()) / (after.frame() - before.frame());
		return new Point(before.at().x() + part * (after.at().x() - before.at().x()),
			before.at().y() + part * (after.at().y() - before.at().y()));
	}

	/**
	 * Follows the free end of the skeletons that is near a place in some frame.
	 *
	 * @param frames the movie
	 * @param place in pixels
	 * @param progress asked whether to stop
	 * @return the place in every frame; the same in all if there is no free end near it
	 */
	static AnchorPath follow(final List<FrameView> frames, final Point place,
		final Progress progress) {
		return EndPaths.past(FreeEnds.of(frames), place, GraphTuning.NEAR_CLAMP, progress)
			.map(path -> along(path, frames.size(), TrackTuning.SKELETON_SHORT))
			.orElseGet(() -> still(place, frames.size()));
	}

	/**
	 * Settles where the end is from what the light says in open frames. If it stays in one
	 * place in all of them, that is its place, and a strong clamp. Otherwise its place is a
	 * random walk through what the light says, the skeletons' ends in other frames, and it is
	 * held the less, the less its place is known.
	 *
	 * @param open fits of open frames
	 * @param middle the place from the clearest frames, in pixels
	 * @return the path; this one is that of the skeletons' ends
	 */
	AnchorPath settled(final OpenFrames open, final Point middle) {
		final List<Seen> seen = open.withFixedEnd();
		return moves(seen) ? walk(seen) : still(middle, places.size());
	}

	/**
	 * Whether little says that the end moves, or stays: skeletons alone, which in noise, or where it
	 * lies on the filament, end anywhere; or open frames of a small part of the movie, in which a
	 * filament that is not evenly bright may seem to begin somewhere else from frame to frame.
	 *
	 * @param open fits of open frames
	 */
	boolean isDoubtful(final OpenFrames open) {
		final int[] seen = open.withFixedEnd().stream().mapToInt(Seen::index).toArray();
		final int n = seen.length;
		return n < TrackTuning.SETTLING
			|| seen[3 * n / 4] - seen[n / 4] < TrackTuning.SETTLING_SPAN * places.size();
	}

	private boolean moves(final List<Seen> seen) {
		if (seen.size() < TrackTuning.SETTLING)
			return moves(places, TrackTuning.STILL_SKELETON);
		final List<Point> ends = seen.stream().map(s -> s.chain().start()).toList();
		return moves(ends, TrackTuning.STILL_END)
			|| drifts(seen.stream().mapToDouble(Seen::index).toArray(), ends);
	}

	/**
	 * Whether an end goes one way, by far more than it strays from that.
	 *
	 * @param at indices of frames, in order
	 * @param ends where it is in each of them, in pixels
	 */
	static boolean drifts(final double[] at, final List<Point> ends) {
		final RobustLine x = RobustLine.through(at, ends.stream().mapToDouble(Point::x).toArray()),
			y = RobustLine.through(at, ends.stream().mapToDouble(Point::y).toArray());
		final double way = Math.hypot(x.slope(), y.slope()) * (at[at.length - 1] - at[0]);
		final double stray = RobustStatistics.median(IntStream.range(0, at.length)
			.mapToDouble(i -> ends.get(i).distanceTo(new Point(x.at(at[i]), y.at(at[i]))))
			.toArray());
		return way > Math.max(TrackTuning.STILL_END, TrackTuning.STEADY * stray);
	}

	/** Whether places, in order of time, are more than a few wrong ones around one place. */
	static boolean moves(final List<Point> all, final double spread) {
		final Point middle = RobustStatistics.upperMedian(all);
		final double[] off = all.stream().mapToDouble(p -> p.distanceTo(middle)).sorted().toArray();
		return off[off.length / 2] > spread
			|| off[(int) (TrackTuning.STILL_SHARE * (off.length - 1))] > 2 * spread;
	}

	private AnchorPath walk(final List<Seen> seen) {
		final int n = places.size();
		final double[] x = new double[n], y = new double[n], noise = new double[n];
		final Point offset = offset(seen);
		for (int t = 0; t < n; t++) {
			x[t] = places.get(t).x() + offset.x();
			y[t] = places.get(t).y() + offset.y();
			noise[t] = TrackTuning.END_NOISE;
		}
		for (final Seen s : seen) {
			x[s.index()] = s.chain().start().x();
			y[s.index()] = s.chain().start().y();
			noise[s.index()] = TrackTuning.LIGHT_NOISE;
		}
		return walk(x, y, noise);
	}

	private static AnchorPath walk(final double[] x, final double[] y, final double[] noise) {
		final int n = x.length;
		final RandomWalk walkX = RandomWalk.through(x, noise), walkY = RandomWalk.through(y, noise);
		final Point[] walk = new Point[n];
		final double[] weight = new double[n];
		for (int t = 0; t < n; t++) {
			walk[t] = new Point(walkX.mean()[t], walkY.mean()[t]);
			final double variance = 0.5
				* (walkX.sd()[t] * walkX.sd()[t] + walkY.sd()[t] * walkY.sd()[t]);
			weight[t] = 1 / (1 / STRONGEST + 2 * variance);
		}
		return new AnchorPath(List.of(walk), weight);
	}

	/** How far the light begins from where the skeleton does, usually. */
	private Point offset(final List<Seen> seen) {
		return seen.isEmpty()
			? new Point(0, 0)
			: RobustStatistics.upperMedian(
				seen.stream().map(s -> new Point(s.chain().start().x() - at(s.index()).x(),
					s.chain().start().y() - at(s.index()).y())).toList());
	}

	/** Largest distance of a place from that in another frame, in pixels. */
	double range() {
		double range = 0;
		for (final Point p : places)
			range = Math.max(range, p.distanceTo(places.get(0)));
		return range;
	}

	/**
	 * The same, settled once more by contours that were not held: a random walk through where they
	 * begin, or a place that they all turn around and begin after.
	 *
	 * @param begin the contours, in every frame
	 */
	AnchorPath refined(final List<Optional<Chain>> begin) {
		final Optional<Point> pivot = StillPivot
			.of(begin.stream().flatMap(Optional::stream).toList());
		if (pivot.isPresent())
			return still(pivot.get(), places.size());
		final int n = places.size();
		final double[] x = new double[n], y = new double[n], noise = new double[n];
		final boolean[] known = known(begin);
		for (int t = 0; t < n; t++) {
			final Point seen = known[t] ? begin.get(t).orElseThrow().start() : at(t);
			x[t] = seen.x();
			y[t] = seen.y();
			noise[t] = known[t] ? TrackTuning.FIT_NOISE : TrackTuning.END_NOISE;
		}
		return walk(x, y, noise);
	}

	/**
	 * Where contours that are not held begin at the fixed end: one or two frames that say that it was
	 * elsewhere and came back, farther than it strays, show another way round.
	 */
	private static boolean[] known(final List<Optional<Chain>> begin) {
		final double[] off = IntStream.range(0, begin.size()).mapToDouble(t -> astray(begin, t))
			.toArray();
		final double most = Math.max(TrackTuning.STILL_SKELETON,
			TrackTuning.STEADY * RobustStatistics.upperMedian(off, 0));
		final boolean[] known = new boolean[off.length];
		for (int t = 0; t < off.length; t++)
			known[t] = begin.get(t).isPresent() && off[t] <= most;
		return known;
	}

	/** How far from where those of two frames before and after usually begin, in pixels. */
	private static double astray(final List<Optional<Chain>> begin, final int t) {
		final List<Point> near = begin.subList(Math.max(0, t - 2), Math.min(begin.size(), t + 3))
			.stream().flatMap(Optional::stream).map(Chain::start).toList();
		return begin.get(t).map(c -> c.start().distanceTo(RobustStatistics.median(near)))
			.orElse(0.);
	}

	/**
	 * The same, but elsewhere in some frames. There the place is held so loosely that the old one is
	 * possible, too: light tells which.
	 *
	 * @param jumps places in pixels, by index of the frame
	 */
	AnchorPath withJumps(final SortedMap<Integer, Point> jumps) {
		final List<Point> moved = new ArrayList<>(places);
		final double[] loosened = weights.clone();
		jumps.forEach((t, place) -> {
			final double far = place.distanceTo(at(t));
			moved.set(t, place);
			loosened[t] = 1 / (1 / STRONGEST + 2 * far * far);
		});
		return new AnchorPath(moved, loosened);
	}

	Point at(final int t) {
		return places.get(t);
	}

	double weight(final int t) {
		return weights[t];
	}

	/** A chain of one frame as it would be in another if it moved with the anchor only. */
	Chain carried(final Chain chain, final int from, final int to) {
		final Point a = places.get(from), b = places.get(to);
		return chain.shifted(b.x() - a.x(), b.y() - a.y());
	}
}
