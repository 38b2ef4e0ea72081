package io.github.knotresolver.track;

import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;

import io.github.knotresolver.fit.Chain;
import io.github.knotresolver.fit.Fit;
import io.github.knotresolver.geometry.RobustStatistics;

/**
 * What it costs a filament to move from one frame to the next: how much farther than
 * usual points at equal arc length from the fixed end, that is the material itself, have
 * moved, and how much farther than usual they have turned. Usual motion is nearly free,
 * whatever the frame interval, so that a contour that stands still is no cheaper than one
 * that follows the filament. A loop that is run the other way round in the next frame
 * covers the same pixels, but has turned by a full turn.
 *
 * @param usualMotion usual mean motion between neighbouring frames in pixels, above 0
 * @param usualTurn usual mean turn between neighbouring frames in radians, above 0
 */
record MotionPrice(double usualMotion, double usualTurn) {

	/**
	 * Learns what is usual from the best fits of neighbouring frames, each for itself.
	 *
	 * @param proposals fits of every frame
	 * @param anchor where the fixed end is; what it moves, all moves
	 */
	static MotionPrice learn(final List<List<Fit>> proposals, final AnchorPath anchor) {
		final List<Chain> best = IntStream.range(0, proposals.size())
			.mapToObj(t -> proposals.get(t).stream().min(Comparator.comparingDouble(Fit::energy))
				.map(f -> anchor.carried(f.chain(), t, 0)))
			.flatMap(Optional::stream).toList();
		final int steps = Math.max(0, best.size() - 1);
		final double[] motion = new double[steps], turn = new double[steps];
		for (int t = 0; t < steps; t++) {
			motion[t] = best.get(t).distance(best.get(t + 1));
			turn[t] = best.get(t).turn(best.get(t + 1));
		}
		return new MotionPrice(
			Math.max(TrackTuning.LEAST_MOTION, RobustStatistics.upperMedian(motion, 0)),
			Math.max(TrackTuning.LEAST_TURN, RobustStatistics.upperMedian(turn, 0)));
	}

	/**
	 * Of filaments whose lengths differ visibly, the part that both have is compared: a
	 * filament grows and breaks at its tip.
	 */
	double between(final Chain a, final Chain b) {
		final double longer = Math.max(a.length(), b.length()),
			shorter = Math.min(a.length(), b.length());
		return longer < TrackTuning.OTHER_LENGTH * shorter
			? moved(a, b)
			: moved(a.resized(shorter), b.resized(shorter));
	}

	/** How many times as far as usual the part that both have moved. */
	double multiple(final Chain a, final Chain b) {
		final double shorter = Math.min(a.length(), b.length());
		return a.resized(shorter).distance(b.resized(shorter)) / usualMotion;
	}

	private double moved(final Chain a, final Chain b) {
		return price(a.distance(b) / usualMotion) + price(a.turn(b) / usualTurn);
	}

	/** The price of something that is so many times as much as usual. */
	static double price(final double multiple) {
		return TrackTuning.USUAL_MOTION * multiple
			+ TrackTuning.FURTHER_MOTION * Math.max(0, multiple - 1);
	}
}
