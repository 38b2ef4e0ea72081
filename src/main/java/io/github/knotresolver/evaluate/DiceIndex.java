package io.github.knotresolver.evaluate;

import java.util.Arrays;

/**
 * The Sørensen-Dice index of points, as the published evaluation defines it: a
 * point within 2 px of the other side's counts as found (Dice 1945,
 * doi:10.2307/1932409).
 */
public final class DiceIndex {

	/** A point this near to the other side counts as found, in pixels. */
	public static final double TOLERANCE = 2;

	private DiceIndex() {
	}

	/**
	 * @param truePositives points of the result near the truth
	 * @param falsePositives other points of the result
	 * @param falseNegatives points of the truth with no point of the result near
	 * @return 2 TP / (2 TP + FP + FN), 0..1; 0 if there are no points at all
	 */
	public static double of(final int truePositives, final int falsePositives,
		final int falseNegatives) {
		final int all = 2 * truePositives + falsePositives + falseNegatives;
		return all == 0 ? 0 : 2.0 * truePositives / all;
	}

	/** @return how many of these distances are within the tolerance */
	static int found(final double[] distances) {
		return (int) Arrays.stream(distances).filter(d -> d <= TOLERANCE).count();
	}
}
