package io.github.knotresolver.track;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;

import org.jgrapht.GraphPath;
import org.jgrapht.alg.shortestpath.BellmanFordShortestPath;
import org.jgrapht.graph.DefaultWeightedEdge;
import org.jgrapht.graph.SimpleDirectedWeightedGraph;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import io.github.knotresolver.progress.Progress;

class TrellisTest {

	private static List<double[]> randomPrices(final Random random, final int most) {
		final List<double[]> prices = new ArrayList<>();
		for (int t = 0; t < 6; t++)
			prices.add(random.doubles(random.nextInt(most + 1), -2, 10).toArray());
		return prices;
	}

	private static Trellis.EdgePrice randomEdges(final long seed) {
		return (from, i, to,
			j) -> new Random(seed + ((from * 31L + i) * 31 + to) * 31 + j).nextDouble() * 10;
	}

	private static double[] bruteForce(final List<double[]> prices, final Trellis.EdgePrice edges,
		final int frame, final int vertex) {
		final double[] best = {Double.POSITIVE_INFINITY};
		walk(prices, edges, frame, vertex, 0, -1, -1, 0, best);
		return best;
	}

	private static void walk(final List<double[]> prices, final Trellis.EdgePrice edges,
		final int frame, final int vertex, final int t, final int before, final int from,
		final double sofar, final double[] best) {
		if (t == prices.size()) {
			best[0] = Math.min(best[0], sofar);
			return;
		}
		if (prices.get(t).length == 0)
			walk(prices, edges, frame, vertex, t + 1, before, from, sofar, best);
		for (int v = 0; v < prices.get(t).length; v++)
			if (t != frame || v == vertex)
				walk(prices, edges, frame, vertex, t + 1, t, v,
					sofar + prices.get(t)[v] + (before < 0 ? 0 : edges.between(before, from, t, v)),
					best);
	}

	@ParameterizedTest
	@ValueSource(longs = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12})
	void everyMinMarginalIsThatOfBruteForce(final long seed) {
		final List<double[]> prices = randomPrices(new Random(seed), 4);
		final Trellis.EdgePrice edges = randomEdges(seed);
		final TrellisPath path = Trellis.solve(prices, edges, Progress.NONE);
		assertEquals(bruteForce(prices, edges, -1, -1)[0], path.total(), 1e-9, "seed " + seed);
		for (int t = 0; t < prices.size(); t++) {
			double second = Double.POSITIVE_INFINITY;
			for (int v = 0; v < prices.get(t).length; v++) {
				final double through = bruteForce(prices, edges, t, v)[0];
				assertEquals(through, path.through()[t][v], 1e-9,
					"seed " + seed + ", vertex " + t + "," + v);
				if (v != path.choice()[t])
					second = Math.min(second, through);
			}
			assertEquals(second - path.total(), path.gap(t, v -> true), 1e-9, "seed " + seed);
		}
	}

	@ParameterizedTest
	@ValueSource(longs = {31, 32, 33, 34, 35})
	void pathIsTheShortestPathOfTheSameGraph(final long seed) {
		final List<double[]> prices = randomPrices(new Random(seed), 12);
		prices.removeIf(p -> p.length == 0);
		final Trellis.EdgePrice edges = randomEdges(seed);
		final SimpleDirectedWeightedGraph<String, DefaultWeightedEdge> graph = new SimpleDirectedWeightedGraph<>(
			DefaultWeightedEdge.class);
		graph.addVertex("start");
		graph.addVertex("end");
		for (int t = 0; t < prices.size(); t++)
			for (int v = 0; v < prices.get(t).length; v++) {
				graph.addVertex(t + "," + v);
				if (t == 0)
					weigh(graph, "start", t + "," + v, prices.get(t)[v]);
				else
					for (int u = 0; u < prices.get(t - 1).length; u++)
						weigh(graph, (t - 1) + "," + u, t + "," + v,
							prices.get(t)[v] + edges.between(t - 1, u, t, v));
				if (t == prices.size() - 1)
					weigh(graph, t + "," + v, "end", 0);
			}
		final GraphPath<String, DefaultWeightedEdge> shortest = new BellmanFordShortestPath<>(graph)
			.getPath("start", "end");
		final TrellisPath path = Trellis.solve(prices, edges, Progress.NONE);
		assertEquals(shortest.getWeight(), path.total(), 1e-9, "seed " + seed);
		final List<String> expected = shortest.getVertexList().subList(1, prices.size() + 1);
		for (int t = 0; t < prices.size(); t++)
			assertEquals(expected.get(t), t + "," + path.choice()[t], "seed " + seed);
	}

	private static void weigh(final SimpleDirectedWeightedGraph<String, DefaultWeightedEdge> graph,
		final String from, final String to, final double weight) {
		graph.setEdgeWeight(graph.addEdge(from, to), weight);
	}

	@Test
	void framesWithoutVerticesAreSkipped() {
		final List<double[]> prices = List.of(new double[0], new double[]{1, 0}, new double[0],
			new double[]{0, 5}, new double[0]);
		final TrellisPath path = Trellis.solve(prices, (from, i, to, j) -> {
			assertEquals(1, from);
			assertEquals(3, to);
			return i == j ? 0 : 10;
		}, Progress.NONE);
		assertArrayEquals(new int[]{-1, 0, -1, 0, -1}, path.choice());
		assertEquals(1, path.total());
		assertEquals(4, path.gap(1, v -> true));
		assertEquals(Double.POSITIVE_INFINITY, path.gap(0, v -> true));
	}

	@Test
	void nothingToChooseFrom() {
		final TrellisPath path = Trellis.solve(List.of(new double[0]), (a, b, c, d) -> 0,
			Progress.NONE);
		assertEquals(0, path.total());
		assertTrue(Arrays.stream(path.choice()).allMatch(c -> c == -1));
		assertEquals(0, Trellis.solve(List.of(), (a, b, c, d) -> 0, Progress.NONE).choice().length);
	}
}
