package io.github.knotresolver.track;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.stream.IntStream;

import io.github.knotresolver.fit.Chain;
import io.github.knotresolver.fit.FilamentFitter;
import io.github.knotresolver.fit.Fit;
import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.geometry.RobustStatistics;

/**
 * Contours whose fixed end was set free: where they begin tells where that end is.
 *
 * @param frames one for each frame in which there is any
 */
record FreedEnds(List<Optional<Freed>> frames) {

	/**
	 * A contour whose fixed end was set free.
	 *
	 * @param chain the contour
	 * @param moved how far it begins from where the fixed end was thought to be, in pixels
	 * @param gain how much cheaper that made it
	 * @param perPixel the light of it that is explained, in strands squared per pixel
	 */
	record Freed(Chain chain, double moved, double gain, double perPixel) {

		/** Both its ends must tell: what lies beyond one is worth no more than the line is. */
		private boolean isJump(final double width, final double usual) {
			return moved > width && gain > Math.max(TrackTuning.JUMPED, perPixel * moved)
				&& gain > TrackTuning.JUMPED_UNUSUAL * usual;
		}
	}

	/**
	 * Light seldom tells at which end a contour begins: one that is hardly dearer from its other end
	 * begins there if that is where the fixed end is known to be.
	 *
	 * @param fit of a contour
	 * @param place of the fixed end in pixels
	 * @param free fits contours that are not held
	 * @return the fit, or that of the same contour the other way round
	 */
	static Fit rightWayRound(final Fit fit, final Point place, final FilamentFitter free) {
		final Chain turned = fit.chain().reversed();
		if (turned.start().distanceTo(place) > TrackTuning.STILL_SKELETON)
			return fit;
		final Fit other = free.price(turned);
		return other.energy() < fit.energy() + TrackTuning.JUMPED ? other : fit;
	}

	/**
	 * Where the fixed end jumped, by index of the frame: in frames in which its contour is so much
	 * better elsewhere as hardly in any other.
	 *
	 * @param width of the line in pixels
	 */
	SortedMap<Integer, Point> jumps(final double width) {
		final double usual = RobustStatistics.upperMedian(gains(), 0);
		final SortedMap<Integer, Point> jumps = new TreeMap<>();
		for (int t = 0; t < frames.size(); t++)
			if (frames.get(t).filter(f -> f.isJump(width, usual)).isPresent())
				jumps.put(t, start(t));
		return jumps;
	}

	/**
	 * Whether an end that was thought to stay is elsewhere in most frames: no farther than skeletons
	 * leave open, or farther and farther one way.
	 *
	 * @param chance how much cheaper noise makes a contour that is not held
	 * @param mayDrift whether it may be farther than skeletons leave open
	 */
	boolean areElsewhere(final double chance, final boolean mayDrift) {
		final double[] gains = gains();
		return gains.length > 0
			&& RobustStatistics.median(gains) > TrackTuning.SURELY_ELSEWHERE * chance
			&& (areNearby() || mayDrift && drift());
	}

	private boolean areNearby() {
		final List<Freed> all = frames.stream().flatMap(Optional::stream).toList();
		return all.stream().filter(f -> f.moved < TrackTuning.STILL_SKELETON)
			.count() > TrackTuning.NEAR_STILL * all.size()
			&& AnchorPath.moves(all.stream().map(f -> f.chain.start()).toList(),
				TrackTuning.STILL_END);
	}

	/** A stage takes the fixed end along, one way, which a few frames do not tell. */
	private boolean drift() {
		final int[] seen = IntStream.range(0, frames.size()).filter(t -> frames.get(t).isPresent())
			.toArray();
		return seen.length >= TrackTuning.SETTLING
			&& AnchorPath.drifts(Arrays.stream(seen).asDoubleStream().toArray(),
				Arrays.stream(seen).mapToObj(this::start).toList());
	}

	/** The contours, in every frame. */
	List<Optional<Chain>> chains() {
		return frames.stream().map(f -> f.map(Freed::chain)).toList();
	}

	/** The contour of a frame that has one. */
	Chain chain(final int t) {
		return frames.get(t).orElseThrow().chain;
	}

	private Point start(final int t) {
		return chain(t).start();
	}

	private double[] gains() {
		return frames.stream().flatMap(Optional::stream).mapToDouble(Freed::gain).toArray();
	}
}
