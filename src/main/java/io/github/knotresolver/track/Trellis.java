package io.github.knotresolver.track;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

import io.github.knotresolver.progress.Progress;

/**
 * The directed graph whose vertices are (frame, candidate) and whose edges join
 * neighbouring frames, and the cheapest path through it. Forward and backward
 * dynamic programming (A. Viterbi, IEEE Trans. Inf. Theory 13 (1967) 260-269,
 * doi:10.1109/TIT.1967.1054010) gives the path and, for every vertex, the cheapest
 * path through it. Frames without vertices are skipped. Time and memory O(frames *
 * vertices per frame²); each edge is priced once.
 */
public final class Trellis {

	/** What it costs to go from a vertex of a trellis to one of a later frame. */
	@FunctionalInterface
	public interface EdgePrice {

		/**
		 * Must give the same price whenever it is asked.
		 *
		 * @param fromFrame 0-based index of the earlier frame
		 * @param from vertex in it
		 * @param toFrame 0-based index of the later frame: the next that has vertices
		 * @param to vertex in it
		 * @return the price, finite
		 */
		double between(int fromFrame, int from, int toFrame, int to);
	}

	private final List<double[]> prices;
	private final List<Integer> frames = new ArrayList<>();
	private final List<double[][]> edges = new ArrayList<>();

	private Trellis(final List<double[]> prices, final EdgePrice edge, final Progress progress) {
		this.prices = prices;
		for (int t = 0; t < prices.size(); t++)
			if (prices.get(t).length > 0)
				frames.add(t);
		for (int k = 1; k < frames.size(); k++) {
			progress.checkCancelled();
			edges.add(priced(frames.get(k - 1), frames.get(k), edge));
		}
	}

	/**
	 * Finds the cheapest path.
	 *
	 * @param vertexPrices for each frame the prices of its vertices, finite; an empty
	 *          array for a frame that is skipped
	 * @param edges prices of edges between neighbouring frames that have vertices
	 * @param progress asked whether to stop
	 * @return the path; of equal ones that with the lowest vertex in the last frame
	 *         where they differ
	 */
	public static TrellisPath solve(final List<double[]> vertexPrices, final EdgePrice edges,
		final Progress progress) {
		return new Trellis(vertexPrices, edges, progress).solve();
	}

	private double[][] priced(final int fromFrame, final int toFrame, final EdgePrice edge) {
		final double[][] matrix = new double[prices.get(fromFrame).length][prices
			.get(toFrame).length];
		for (int i = 0; i < matrix.length; i++)
			for (int j = 0; j < matrix[i].length; j++)
				matrix[i][j] = edge.between(fromFrame, i, toFrame, j);
		return matrix;
	}

	private TrellisPath solve() {
		final int[] choice = new int[prices.size()];
		Arrays.fill(choice, -1);
		final double[][] through = prices.stream().map(double[]::clone).toArray(double[][]::new);
		if (frames.isEmpty())
			return new TrellisPath(choice, through, 0);
		final double[][] before = forward(), after = backward();
		for (int k = 0; k < frames.size(); k++)
			for (int v = 0; v < before[k].length; v++)
				through[frames.get(k)][v] = before[k][v] + after[k][v];
		trace(before, choice);
		final int last = frames.get(frames.size() - 1);
		return new TrellisPath(choice, through, through[last][choice[last]]);
	}

	/** Cheapest way to each vertex, its own price included. */
	private double[][] forward() {
		final double[][] cost = new double[frames.size()][];
		cost[0] = prices.get(frames.get(0)).clone();
		for (int k = 1; k < cost.length; k++) {
			cost[k] = prices.get(frames.get(k)).clone();
			for (int j = 0; j < cost[k].length; j++) {
				final int i = cheapest(cost[k - 1], k, j);
				cost[k][j] += cost[k - 1][i] + edges.get(k - 1)[i][j];
			}
		}
		return cost;
	}

	private int cheapest(final double[] before, final int k, final int j) {
		int best = 0;
		for (int i = 1; i < before.length; i++)
			if (before[i] + edges.get(k - 1)[i][j] < before[best] + edges.get(k - 1)[best][j])
				best = i;
		return best;
	}

	/** Cheapest way on from each vertex, its own price not included. */
	private double[][] backward() {
		final double[][] cost = new double[frames.size()][];
		cost[cost.length - 1] = new double[prices.get(frames.get(cost.length - 1)).length];
		for (int k = cost.length - 2; k >= 0; k--) {
			cost[k] = new double[prices.get(frames.get(k)).length];
			final double[] next = prices.get(frames.get(k + 1));
			for (int i = 0; i < cost[k].length; i++) {
				double best = Double.POSITIVE_INFINITY;
				for (int j = 0; j < next.length; j++)
					best = Math.min(best, edges.get(k)[i][j] + next[j] + cost[k + 1][j]);
				cost[k][i] = best;
			}
		}
		return cost;
	}

	private void trace(final double[][] before, final int[] choice) {
		int k = frames.size() - 1;
		int v = 0;
		for (int i = 1; i < before[k].length; i++)
			if (before[k][i] < before[k][v])
				v = i;
		choice[frames.get(k)] = v;
		for (; k > 0; k--) {
			v = cheapest(before[k - 1], k, v);
			choice[frames.get(k - 1)] = v;
		}
	}
}
