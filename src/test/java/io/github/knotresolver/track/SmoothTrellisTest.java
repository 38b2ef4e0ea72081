package io.github.knotresolver.track;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.Random;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import io.github.knotresolver.Drawn;
import io.github.knotresolver.fit.Chain;
import io.github.knotresolver.fit.Fit;
import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.progress.Progress;

/** Paths through a trellis in which it costs to change course. */
class SmoothTrellisTest {

	private static final int FRAMES = 7;

	/** Something between 0 and 1 that depends on its arguments only. */
	private static double random(final long... of) {
		long mixed = 17;
		for (final long value : of)
			mixed = mixed * 1_000_003 + value;
		return new Random(mixed).nextDouble();
	}

	private static List<double[]> prices(final long seed) {
		final Random random = new Random(seed);
		final List<double[]> prices = new ArrayList<>();
		for (int t = 0; t < FRAMES; t++)
			prices.add(random.doubles(random.nextInt(4), -2, 4).toArray());
		return prices;
	}

	private static double edge(final long seed, final int t, final int i, final int u,
		final int j) {
		return 2 * random(seed, 1, t, i, u, j);
	}

	private static double course(final long seed, final int t, final int i, final int j,
		final int k) {
		return 2 * random(seed, 2, t, i, j, k);
	}

	/** The cheapest way that has a vertex in a frame, by trying all. */
	private static double cheapest(final List<double[]> prices, final long seed, final int frame,
		final int vertex, final List<int[]> way) {
		final int t = way.isEmpty() ? 0 : way.get(way.size() - 1)[0] + 1;
		for (int u = t; u < prices.size(); u++)
			if (prices.get(u).length > 0) {
				double best = Double.POSITIVE_INFINITY;
				for (int v = 0; v < prices.get(u).length; v++) {
					if (u == frame && v != vertex)
						continue;
					final List<int[]> on = new ArrayList<>(way);
					on.add(new int[]{u, v});
					best = Math.min(best, cheapest(prices, seed, frame, vertex, on));
				}
				return best;
			}
		double price = 0;
		for (int k = 0; k < way.size(); k++) {
			final int[] c = way.get(k);
			price += prices.get(c[0])[c[1]];
			if (k == 0)
				continue;
			final int[] b = way.get(k - 1);
			price += edge(seed, b[0], b[1], c[0], c[1]);
			if (k > 1 && way.get(k - 2)[0] == c[0] - 2)
				price += course(seed, c[0] - 2, way.get(k - 2)[1], b[1], c[1]);
		}
		return price;
	}

	@ParameterizedTest
	@ValueSource(longs = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16})
	void givesTheCheapestPathThroughEveryVertex(final long seed) {
		final List<double[]> prices = prices(seed);
		final Trellis.EdgePrice edge = (t, i, u, j) -> edge(seed, t, i, u, j);
		final TrellisPath path = SmoothTrellis.solve(Trellis.solve(prices, edge, Progress.NONE),
			prices, edge, (t, i, j, k) -> course(seed, t, i, j, k), Progress.NONE);
		for (int t = 0; t < FRAMES; t++) {
			for (int v = 0; v < prices.get(t).length; v++)
				assertEquals(cheapest(prices, seed, t, v, List.of()), path.through()[t][v], 1e-9,
					"seed " + seed + ", frame " + t + ", vertex " + v);
			if (prices.get(t).length > 0)
				assertEquals(path.total(), path.through()[t][path.choice()[t]], 1e-9,
					"seed " + seed + ", frame " + t);
			else
				assertEquals(-1, path.choice()[t]);
		}
	}

	@Test
	void whatIsHopelessStaysAsMuchDearerAsItWas() {
		final List<double[]> prices = List.of(new double[]{0}, new double[]{0, 1000},
			new double[]{0}, new double[]{0});
		final TrellisPath path = SmoothTrellis.solve(
			Trellis.solve(prices, (t, i, u, j) -> 0, Progress.NONE), prices, (t, i, u, j) -> 0,
			(t, i, j, k) -> 3, Progress.NONE);
		assertEquals(6, path.total(), 1e-9);
		assertEquals(1006, path.through()[1][1], 1e-9);
	}

	/** A filament that sweeps down steadily, in frame t, and a bump of its middle. */
	private static Fit sweeping(final int t, final double bump, final double energy) {
		return new Fit(Chain.along(Drawn.line(10, 20 + 2 * t, 40, 20 + 2 * t, 55, 20 + 2 * t + bump,
			70, 20 + 2 * t, 100, 20 + 2 * t), 30, 90), energy, energy, 1);
	}

	private static TrellisPath path(final double gain) {
		final List<List<Fit>> pools = new ArrayList<>();
		for (int t = 0; t < 14; t++)
			pools.add(t < 4 || t > 9
				? List.of(sweeping(t, 0, -50))
				: List.of(sweeping(t, 0, -50), sweeping(t, 6, -50 - gain)));
		return FitTrellis.course(pools, AnchorPath.still(new Point(10, 20), 14),
			new MotionPrice(2, 0.1), Progress.NONE).path();
	}

	@Test
	void whatMovesSteadilyDoesNotJumpAsideForALittleLight() {
		assertTrue(sweeping(5, 0, 0).chain().distance(sweeping(5, 6, 0).chain()) < 2,
			"the jump is no farther than usual motion");
		for (int t = 0; t < 14; t++)
			assertEquals(0, path(1).choice()[t], "frame " + t);
		assertEquals(1, path(20).choice()[6], "for much light it does");
	}

	@Test
	void changeOfCourseIsThatOfTheMaterialRelativeToTheFixedEnd() {
		final List<Optional<Chain>> steady = new ArrayList<>();
		for (int t = 0; t < 6; t++)
			steady.add(Optional.of(sweeping(t, 0, 0).chain()));
		final AnchorPath still = AnchorPath.still(new Point(10, 20), 6);
		final Inertia inertia = new Inertia(steady, still);
		assertEquals(TrackTuning.LEAST_CHANGE, inertia.usual(), 1e-9);
		final Chain here = sweeping(2, 0, 0).chain();
		assertEquals(0,
			inertia.price(2, sweeping(1, 0, 0).chain(), here, sweeping(3, 0, 0).chain()), 1e-9);
		assertTrue(inertia.price(2, here, here.shifted(0, 3), here) > 10);
		final List<Point> jolted = new ArrayList<>(Collections.nCopies(6, new Point(10, 20)));
		jolted.set(2, new Point(10, 23));
		assertEquals(0, new Inertia(steady, new AnchorPath(jolted, new double[6])).price(2, here,
			here.shifted(0, 3), here), 1e-9, "the stage was jolted");
	}
}
