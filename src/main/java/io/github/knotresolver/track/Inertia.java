package io.github.knotresolver.track;

import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;

import io.github.knotresolver.fit.Chain;
import io.github.knotresolver.geometry.RobustStatistics;

/**
 * What it costs a filament to change its course from one step to the next: its material keeps
 * its velocity, as far as that is usual in this movie. Where frames are close in time that tells
 * two strands apart that lie near each other for long: exchanged ones must have jumped once.
 *
 * @param usual change of velocity, mean over the filament, in pixels per frame, above 0
 * @param anchor where the fixed end is; what it moves, all moves
 */
record Inertia(double usual, AnchorPath anchor) {

	/**
	 * Learns what is usual.
	 *
	 * @param chains one for each frame, as far as there is one
	 */
	static Inertia learn(final List<Optional<Chain>> chains, final AnchorPath anchor) {
		final double[] changes = IntStream.range(1, Math.max(1, chains.size() - 1))
			.filter(t -> chains.subList(t - 1, t + 2).stream().allMatch(Optional::isPresent))
			.mapToDouble(t -> change(anchor, t, chains.get(t - 1).get(), chains.get(t).get(),
				chains.get(t + 1).get()))
			.toArray();
		return new Inertia(
			Math.max(TrackTuning.LEAST_CHANGE, RobustStatistics.upperMedian(changes, 0)), anchor);
	}

	/**
	 * @param t index of the middle one of three frames
	 * @return the price, at least 0
	 */
	double price(final int t, final Chain before, final Chain here, final Chain after) {
		return MotionPrice.price(change(anchor, t, before, here, after) / usual);
	}

	private static double change(final AnchorPath anchor, final int t, final Chain before,
		final Chain here, final Chain after) {
		final double shortest = Math.min(here.length(), Math.min(before.length(), after.length()));
		return here.resized(shortest).changeOfCourse(
			anchor.carried(before, t - 1, t).resized(shortest),
			anchor.carried(after, t + 1, t).resized(shortest));
	}
}
