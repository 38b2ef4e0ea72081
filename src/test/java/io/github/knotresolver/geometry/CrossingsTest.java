package io.github.knotresolver.geometry;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.stream.IntStream;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class CrossingsTest {

	@ParameterizedTest
	@CsvSource(delimiter = '|', value = {"inside two links|0 0, 2 2, 2 0, 0 2|1",
		"a vertex of one strand|0 0, 1 1, 2 2, 2 0, 0 2|1",
		"a vertex of the other|0 0, 2 2, 2 0, 1 1, 0 2|1",
		"vertices of both|0 0, 1 1, 2 2, 2 0, 1 1, 0 2|1",
		"touched at a vertex|0 0, 4 0, 4 2, 2 0, 0 2|0",
		"touched at vertices of both|0 0, 2 0, 4 0, 4 2, 2 0, 0 2|0",
		"along each other, sides exchanged|0 1, 1 0, 2 0, 3 0, 4 -1, 6 0, 5 3, 0 3, -2 -1, 0 -1, 1 0, 2 0, 3 0, 4 1|1",
		"along each other, sides kept|0 1, 1 0, 2 0, 3 0, 4 1, 4 3, -2 3, -2 -1, 0 -1, 1 0, 2 0, 3 0, 4 -1|0",
		"against each other, sides exchanged|0 1, 1 0, 3 0, 4 -1, 6 0, 4 1, 3 0, 1 0, 0 -1|1",
		"against each other, sides kept|0 1, 1 0, 3 0, 4 1, 6 0, 4 -1, 3 0, 1 0, 0 -1|0",
		"an end upon the curve|0 0, 4 0, 4 2, 2 2, 2 0|0", "a closed curve|0 0, 2 0, 2 2, 0 0|0",
		"back along itself|0 0, 3 0, 1 0, 1 2|0", "rests|0 0, 1 1, 1 1, 2 2, 2 0, 2 0, 0 2|1",
		"a single point|1 1|0"})
	void meetingsAreCrossingsIfSidesAreExchanged(final String what, final String points,
		final int crossings) {
		final Polyline curve = curve(points);
		assertEquals(crossings, Crossings.of(curve).size(), what);
		assertEquals(crossings, Crossings.of(curve.reversed()).size(), what + ", reversed");
	}

	@Test
	void crossingsComeInTheOrderOfTheFirstStrand() {
		final List<Point> found = Crossings
			.of(curve("0 0, 10 0, 10 2, 8 0, 8 -2, 5 -2, 5 2, 2 2, 2 -2"));
		assertEquals(List.of(new Point(2, 0), new Point(5, 0), new Point(8, 0)), found);
	}

	/** Where rounding decides: the vertex lies beside the link by less than an ulp's product. */
	@Test
	void sidesAreExact() {
		final Point a = new Point(0.5, 0.5), b = new Point(12, 12);
		for (int k = -3; k <= 3; k++) {
			final double x = 0.5 + k * Math.ulp(0.5);
			assertEquals(-k < 0 ? -1 : -k > 0 ? 1 : 0,
				Orientation.of(a, b, new Point(24 + 0 * x + k * Math.ulp(24.0), 24)), "k = " + k);
		}
	}

	/**
	 * Strands that cross do so however little all vertices are moved; what can be
	 * undone by moving them is a touch. The oracle counts proper crossings of moved
	 * copies and takes the least.
	 */
	@Test
	void leastNumberOfCrossingsOfCurvesMovedALittle() {
		for (long seed = 0; seed < 600; seed++) {
			final Random random = new Random(seed);
			final Polyline curve = onAGrid(random);
			int least = Integer.MAX_VALUE;
			for (int k = 0; k < 400; k++)
				least = Math.min(least, proper(moved(curve, random)));
			assertEquals(least, Crossings.of(curve).size(), "seed " + seed + ": " + IntStream
				.range(0, curve.size()).mapToObj(curve::point).map(Point::toString).toList());
		}
	}

	/** A walk on a 4 x 4 grid that does not turn back on the spot. */
	private static Polyline onAGrid(final Random random) {
		final List<Point> points = new ArrayList<>();
		final int n = 4 + random.nextInt(5);
		while (points.size() < n) {
			final Point next = new Point(random.nextInt(4), random.nextInt(4));
			final int k = points.size();
			if (k > 0 && next.equals(points.get(k - 1))
				|| k > 1 && Orientation.of(points.get(k - 2), points.get(k - 1), next) == 0)
				continue;
			points.add(next);
		}
		return Polyline.of(points);
	}

	private static Polyline moved(final Polyline curve, final Random random) {
		final double[] x = curve.xs(), y = curve.ys();
		for (int i = 0; i < x.length; i++) {
			x[i] += 1e-4 * (random.nextDouble() - 0.5);
			y[i] += 1e-4 * (random.nextDouble() - 0.5);
		}
		return Polyline.of(x, y);
	}

	private static int proper(final Polyline c) {
		int crossings = 0;
		for (int i = 0; i < c.size() - 1; i++)
			for (int j = i + 2; j < c.size() - 1; j++)
				if (apart(c, i, j) && apart(c, j, i))
					crossings++;
		return crossings;
	}

	/** Whether the ends of link j lie on different sides of link i. */
	private static boolean apart(final Polyline c, final int i, final int j) {
		return side(c, i, j) * side(c, i, j + 1) < 0;
	}

	private static double side(final Polyline c, final int i, final int k) {
		return (c.x(i + 1) - c.x(i)) * (c.y(k) - c.y(i))
			- (c.y(i + 1) - c.y(i)) * (c.x(k) - c.x(i));
	}

	private static Polyline curve(final String text) {
		final List<Point> points = new ArrayList<>();
		for (final String pair : text.split(", ")) {
			final String[] xy = pair.split(" ");
			points.add(new Point(Double.parseDouble(xy[0]), Double.parseDouble(xy[1])));
		}
		return Polyline.of(points);
	}
}
