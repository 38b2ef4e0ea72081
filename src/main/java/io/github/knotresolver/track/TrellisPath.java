package io.github.knotresolver.track;

import java.util.function.IntPredicate;

/**
 * The cheapest path through a trellis.
 *
 * @param choice the vertex chosen in each frame; -1 in frames without vertices
 * @param through the price of the cheapest path through each vertex of each frame
 *          (min-marginal); that of a chosen vertex is {@code total}
 * @param total the price of the cheapest path; 0 if no frame has vertices
 */
public record TrellisPath(int[] choice, double[][] through, double total) {

	/**
	 * How much dearer the cheapest path is that differs in a frame.
	 *
	 * @param frame 0-based index of the frame
	 * @param different which of the frame's vertices count as different from the chosen one
	 * @return the difference in price, at least 0; infinite if the frame has no such vertex
	 */
	public double gap(final int frame, final IntPredicate different) {
		double second = Double.POSITIVE_INFINITY;
		for (int v = 0; v < through[frame].length; v++)
			if (v != choice[frame] && different.test(v))
				second = Math.min(second, through[frame][v]);
		return Math.max(0, second - total);
	}
}
