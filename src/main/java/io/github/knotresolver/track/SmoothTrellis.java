package io.github.knotresolver.track;

import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;

import io.github.knotresolver.progress.Progress;

/**
 * The cheapest path through a trellis in which it also costs to change course from one step to
 * the next: the same dynamic programming over pairs of neighbouring vertices. Only vertices that
 * are not hopeless without that price are looked at. O(frames * such vertices per frame³).
 */
final class SmoothTrellis {

	/** What it costs to be at three vertices of three frames that follow each other. */
	@FunctionalInterface
	interface CoursePrice {

		/**
		 * @param frame index of the first of them
		 * @param first vertex in it
		 * @param second vertex in the next frame
		 * @param third vertex in the one after that
		 * @return the price, none negative, finite
		 */
		double along(int frame, int first, int second, int third);
	}

	private final List<double[]> prices;
	private final Trellis.EdgePrice edge;
	private final CoursePrice course;
	private final Progress progress;
	private final int[][] kept;

	private SmoothTrellis(final List<double[]> prices, final Trellis.EdgePrice edge,
		final CoursePrice course, final int[][] kept, final Progress progress) {
		this.prices = prices;
		this.edge = edge;
		this.course = course;
		this.kept = kept;
		this.progress = progress;
	}

	/**
	 * Finds the cheapest path.
	 *
	 * @param plain the cheapest path if changing course costs nothing
	 * @param prices for each frame the prices of its vertices
	 * @param edge of going from a vertex to one of the next frame
	 * @param course of changing course; nothing where a frame without vertices lies between
	 * @param progress asked whether to stop
	 * @return the path
	 */
	static TrellisPath solve(final TrellisPath plain, final List<double[]> prices,
		final Trellis.EdgePrice edge, final CoursePrice course, final Progress progress) {
		final double most = plain.total() + TrackTuning.COURSE_HOPELESS;
		final int[][] kept = Arrays.stream(plain.through()).map(
			through -> IntStream.range(0, through.length).filter(v -> through[v] <= most).toArray())
			.toArray(int[][]::new);
		return new SmoothTrellis(prices, edge, course, kept, progress).solve(plain);
	}

	private TrellisPath solve(final TrellisPath plain) {
		final int[] frames = IntStream.range(0, kept.length).filter(t -> kept[t].length > 0)
			.toArray();
		if (frames.length < 3)
			return plain;
		final double[][][] edges = new double[frames.length][][];
		for (int k = 1; k < frames.length; k++)
			edges[k] = edges(frames[k - 1], frames[k]);
		return joined(plain, frames, edges, forward(frames, edges));
	}

	private double[][] edges(final int from, final int to) {
		progress.checkCancelled();
		final double[][] matrix = new double[kept[from].length][kept[to].length];
		for (int i = 0; i < matrix.length; i++)
			for (int j = 0; j < matrix[i].length; j++)
				matrix[i][j] = edge.between(from, kept[from][i], to, kept[to][j]);
		return matrix;
	}

	private double price(final int frame, final int vertex) {
		return prices.get(frame)[kept[frame][vertex]];
	}

	private double turn(final int[] frames, final int k, final int... vertices) {
		final int t = frames[k];
		return frames[k + 2] - t > 2
			? 0
			: course.along(t, kept[t][vertices[0]], kept[t + 1][vertices[1]],
				kept[t + 2][vertices[2]]);
	}

	/** Cheapest way to each pair, both prices included. */
	private double[][][] forward(final int[] frames, final double[][][] edges) {
		final double[][][] cost = new double[frames.length][][];
		for (int k = 1; k < frames.length; k++) {
			progress.checkCancelled();
			cost[k] = new double[edges[k].length][];
			for (int i = 0; i < edges[k].length; i++) {
				cost[k][i] = edges[k][i].clone();
				for (int j = 0; j < cost[k][i].length; j++)
					cost[k][i][j] += price(frames[k], j)
						+ (k == 1 ? price(frames[0], i) : cheapestTo(frames, cost, k, i, j));
			}
		}
		return cost;
	}

	private double cheapestTo(final int[] frames, final double[][][] cost, final int k, final int i,
		final int j) {
		double best = Double.POSITIVE_INFINITY;
		for (int h = 0; h < cost[k - 1].length; h++)
			best = Math.min(best, cost[k - 1][h][i] + turn(frames, k - 2, h, i, j));
		return best;
	}

	/** From the last frame to the first: the path, and what is cheapest through each vertex. */
	private TrellisPath joined(final TrellisPath plain, final int[] frames,
		final double[][][] edges, final double[][][] to) {
		final int last = frames.length - 1;
		double[][] from = new double[to[last].length][to[last][0].length];
		final double total = least(to[last], from);
		final double[][] through = Arrays.stream(plain.through())
			.map(v -> Arrays.stream(v).map(p -> p - plain.total() + total).toArray())
			.toArray(double[][]::new);
		final int[] choice = plain.choice().clone();
		Arrays.fill(choice, -1);
		for (int k = last; k > 0; k--) {
			progress.checkCancelled();
			if (k < last)
				from = onward(frames, edges, from, k);
			set(through[frames[k]], kept[frames[k]], ends(to[k], from, true));
			if (k == 1)
				set(through[frames[0]], kept[frames[0]], ends(to[1], from, false));
		}
		trace(frames, to, choice);
		return new TrellisPath(choice, through, total);
	}

	/** Cheapest way on from each pair whose second vertex is in the k-th frame. */
	private double[][] onward(final int[] frames, final double[][][] edges, final double[][] next,
		final int k) {
		final double[][] from = new double[edges[k].length][edges[k + 1].length];
		for (int i = 0; i < from.length; i++)
			for (int j = 0; j < from[i].length; j++) {
				double best = Double.POSITIVE_INFINITY;
				for (int l = 0; l < next[j].length; l++)
					best = Math.min(best, edges[k + 1][j][l] + price(frames[k + 1], l) + next[j][l]
						+ turn(frames, k - 1, i, j, l));
				from[i][j] = best;
			}
		return from;
	}

	private static double least(final double[][] to, final double[][] from) {
		return Arrays.stream(ends(to, from, true)).min().orElse(0);
	}

	/** Of all pairs with the same second (or first) vertex the cheapest. */
	private static double[] ends(final double[][] to, final double[][] from, final boolean second) {
		final double[] best = new double[second ? to[0].length : to.length];
		Arrays.fill(best, Double.POSITIVE_INFINITY);
		for (int i = 0; i < to.length; i++)
			for (int j = 0; j < to[i].length; j++) {
				final int v = second ? j : i;
				best[v] = Math.min(best[v], to[i][j] + from[i][j]);
			}
		return best;
	}

	private static void set(final double[] through, final int[] vertices, final double[] values) {
		for (int v = 0; v < vertices.length; v++)
			through[vertices[v]] = values[v];
	}

	private void trace(final int[] frames, final double[][][] to, final int[] choice) {
		int k = frames.length - 1;
		int i = 0, j = 0;
		for (int a = 0; a < to[k].length; a++)
			for (int b = 0; b < to[k][a].length; b++)
				if (to[k][a][b] < to[k][i][j]) {
					i = a;
					j = b;
				}
		choice[frames[k]] = kept[frames[k]][j];
		choice[frames[k - 1]] = kept[frames[k - 1]][i];
		for (; k > 1; k--) {
			int best = 0;
			for (int h = 1; h < to[k - 1].length; h++)
				if (to[k - 1][h][i] + turn(frames, k - 2, h, i, j) < to[k - 1][best][i]
					+ turn(frames, k - 2, best, i, j))
					best = h;
			choice[frames[k - 2]] = kept[frames[k - 2]][best];
			j = i;
			i = best;
		}
	}
}
