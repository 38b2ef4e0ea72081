
package io.github.knotresolver.track;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;

import io.github.knotresolver.geometry.RobustStatistics;
import io.github.knotresolver.progress.Cancellation;

/**
 * A length that grows, shrinks and stays by turns, each at a steady rate, as that of a
 * microtubule does: straight pieces from one known length to another, joined. Which those are
 * is found by dynamic programming, exactly and in O(n³) for n lengths; of more than {@value #MOST},
 * only so many may be an end of a phase, so that it is O(n) beyond.
 *
 * @param lengths in pixels by index of the frame
 * @param turns how often the rate changes
 */
record LengthPhases(double[] lengths, int turns) {

	/** Of more lengths, so many that are spread evenly may be the end of a phase. */
	private static final int MOST = 500;

	/**
	 * The phases that explain some lengths most cheaply.
	 *
	 * @param seen index of each frame in which the length is known, in order
	 * @param known those lengths in pixels, at least four
	 * @param frames number of frames
	 * @param error standard deviation of a length in pixels
	 * @param turn price of a turn
	 */
	static LengthPhases of(final int[] seen, final double[] known, final int frames,
		final double error, final double turn) {
		final int[] ends = ends(known.length);
		final int last = ends.length - 1;
		final double[] calm = calm(known), cost = new double[ends.length];
		final int[] from = new int[ends.length];
		Arrays.fill(cost, 1, ends.length, Double.POSITIVE_INFINITY);
		for (int j = 1; j <= last; j++) {
			Cancellation.check();
			for (int i = 0; i < j; i++) {
				final double price = cost[i] + (i > 0 ? turn : 0);
				if ((i == 0 || j == last || ends[j] - ends[i] >= TrackTuning.BESIDE_BREAK)
					&& price < cost[j]) {
					final double whole = price + misfit(seen, known, calm,
						new int[]{ends[i], ends[j]}, error, cost[j] - price);
					if (whole < cost[j]) {
						cost[j] = whole;
						from[j] = i;
					}
				}
			}
		}
		final List<Integer> knots = new ArrayList<>(List.of(ends[last]));
		for (int j = last; j > 0; j = from[j])
			knots.add(0, ends[from[j]]);
		return new LengthPhases(drawn(seen, calm, frames, knots), knots.size() - 2);
	}

	/** Where a phase may end: at all known lengths but the first and last one, or at some of them. */
	private static int[] ends(final int known) {
		final int span = known - 3, count = Math.min(span, MOST - 1) + 1;
		return IntStream.range(0, count).map(i -> 1 + (int) ((long) i * span / (count - 1)))
			.toArray();
	}

	/** Medians of three: one wrong length is no end of a phase. */
	private static double[] calm(final double[] known) {
		final double[] calm = known.clone();
		for (int k = 1; k + 1 < calm.length; k++)
			calm[k] = RobustStatistics.median(Arrays.copyOfRange(known, k - 1, k + 2));
		return calm;
	}

	/** Of the lengths within a phase, from the line between its ends; or more than enough. */
	private static double misfit(final int[] seen, final double[] known, final double[] calm,
		final int[] phase, final double error, final double enough) {
		double sum = 0;
		for (int k = phase[0]; k < phase[1] && sum < enough; k++) {
			final double off = Math.min(2 * TrackTuning.LENGTH_OUTLIER,
				Math.abs(known[k] - on(seen, calm, phase, seen[k])) / error);
			sum += 0.5 * off * off;
		}
		return sum;
	}

	/** The length in a frame by the line between two known ones. */
	private static double on(final int[] seen, final double[] calm, final int[] phase,
		final int t) {
		final int i = phase[0], j = phase[1];
		return calm[i] + (calm[j] - calm[i]) * (t - seen[i]) / (seen[j] - seen[i]);
	}

	/** Before the first end and after the last one as beside them. */
	private static double[] drawn(final int[] seen, final double[] calm, final int frames,
		final List<Integer> knots) {
		final double[] lengths = new double[frames];
		final double least = LengthCourse.least(calm);
		int p = 1;
		for (int t = 0; t < frames; t++) {
			while (p + 1 < knots.size() && t >= seen[knots.get(p)])
				p++;
			lengths[t] = Math.max(least,
				on(seen, calm, new int[]{knots.get(p - 1), knots.get(p)}, t));
		}
		return lengths;
	}
}
