package io.github.knotresolver.contour;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Random;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import io.github.knotresolver.Drawn;
import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.graph.SkeletonGraph;

class GeodesicOrderTest {

	@ParameterizedTest
	@ValueSource(longs = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10})
	void distancesAreThoseOfAllPairsShortestPaths(final long seed) {
		final Random random = new Random(seed);
		final List<Point> pixels = new ArrayList<>();
		for (int y = 0; y < 7; y++)
			for (int x = 0; x < 7; x++)
				if (random.nextInt(10) < 6)
					pixels.add(new Point(x, y));
		final int seedPixel = random.nextInt(pixels.size());
		final double[] expected = floydWarshall(pixels)[seedPixel];
		final double[] found = GeodesicOrder.distances(pixels, pixels.get(seedPixel));
		for (int i = 0; i < expected.length; i++)
			assertEquals(expected[i], found[i], 1e-9, "seed " + seed + ", pixel " + pixels.get(i));
	}

	private static double[][] floydWarshall(final List<Point> pixels) {
		final int n = pixels.size();
		final double[][] d = new double[n][n];
		for (int i = 0; i < n; i++) {
			Arrays.fill(d[i], Double.POSITIVE_INFINITY);
			for (int j = 0; j < n; j++)
				if (pixels.get(i).distanceTo(pixels.get(j)) < 1.5)
					d[i][j] = pixels.get(i).distanceTo(pixels.get(j));
		}
		for (int k = 0; k < n; k++)
			for (int i = 0; i < n; i++)
				for (int j = 0; j < n; j++)
					d[i][j] = Math.min(d[i][j], d[i][k] + d[k][j]);
		return d;
	}

	@Test
	void shuffledSkeletonComesBackInOrder() {
		final Polyline chain = SkeletonGraph
			.of(Drawn.skeleton(80, 60, Drawn.line(5, 5, 40, 20, 60, 40, 66, 55))).segments().get(0)
			.chain();
		final List<Point> pixels = new ArrayList<>();
		for (int i = 0; i < chain.size(); i++)
			pixels.add(chain.point(i));
		Collections.shuffle(pixels, new Random(7));
		assertEquals(chain, GeodesicOrder.order(pixels, chain.first()));
		assertEquals(chain.reversed(), GeodesicOrder.order(pixels, chain.last()));
	}

	@Test
	void whatCannotBeReachedIsLeftOut() {
		final List<Point> pixels = List.of(new Point(0, 0), new Point(1, 1), new Point(5, 5));
		assertEquals(2, GeodesicOrder.order(pixels, new Point(0, 0)).size());
		assertThrows(IllegalArgumentException.class,
			() -> GeodesicOrder.order(List.of(), new Point(0, 0)));
	}
}
