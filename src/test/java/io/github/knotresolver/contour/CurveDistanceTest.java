package io.github.knotresolver.contour;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;
import java.util.function.DoubleBinaryOperator;
import java.util.stream.IntStream;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import io.github.knotresolver.Drawn;
import io.github.knotresolver.geometry.Polyline;

class CurveDistanceTest {

	private static Polyline random(final Random random) {
		final int n = 1 + random.nextInt(6);
		return Polyline.of(random.doubles(n, 0, 20).toArray(), random.doubles(n, 0, 20).toArray());
	}

	/** The best of all monotonic alignments, every one of them walked. */
	private static double best(final Polyline a, final Polyline b, final int i, final int j,
		final double sofar, final DoubleBinaryOperator join) {
		final double here = join.applyAsDouble(sofar, a.point(i).distanceTo(b.point(j)));
		if (i == a.size() - 1 && j == b.size() - 1)
			return here;
		double best = Double.POSITIVE_INFINITY;
		if (i < a.size() - 1)
			best = Math.min(best, best(a, b, i + 1, j, here, join));
		if (j < b.size() - 1)
			best = Math.min(best, best(a, b, i, j + 1, here, join));
		if (i < a.size() - 1 && j < b.size() - 1)
			best = Math.min(best, best(a, b, i + 1, j + 1, here, join));
		return best;
	}

	@ParameterizedTest
	@ValueSource(longs = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20})
	void warpingAndFrechetAreTheBestOfAllAlignments(final long seed) {
		final Random random = new Random(seed);
		final Polyline a = random(random), b = random(random);
		assertEquals(best(a, b, 0, 0, 0, Double::sum), DynamicTimeWarping.distance(a, b), 1e-9,
			"seed " + seed);
		assertEquals(best(a, b, 0, 0, 0, Math::max), DiscreteFrechet.distance(a, b), 1e-9,
			"seed " + seed);
		assertEquals(DynamicTimeWarping.distance(a, b), DynamicTimeWarping.distance(b, a), 1e-9);
		assertEquals(DiscreteFrechet.distance(a, b), DiscreteFrechet.distance(b, a), 1e-9);
	}

	@Test
	void equalCurvesAreNotApart() {
		final Polyline c = Drawn.line(0, 0, 10, 5, 20, 0).resampled(1);
		assertEquals(0, DynamicTimeWarping.distance(c, c));
		assertEquals(0, DiscreteFrechet.distance(c, c));
		assertEquals(0, EqualArcDistance.mean(c, c));
	}

	@Test
	void shiftedLinesAreApartByTheShift() {
		final Polyline a = Drawn.line(0, 0, 50, 0).resampled(1),
			b = Drawn.line(0, 3, 50, 3).resampled(1);
		assertEquals(3, DynamicTimeWarping.normalised(a, b), 1e-9);
		assertEquals(3, DiscreteFrechet.distance(a, b), 1e-9);
		assertEquals(3, EqualArcDistance.mean(a, b), 1e-9);
		assertEquals(3, EqualArcDistance.meanOfSampled(a.every(4), b.every(4)), 1e-9);
	}

	@Test
	void directionCounts() {
		final Polyline a = Drawn.line(0, 0, 50, 0).resampled(1);
		assertEquals(50, DiscreteFrechet.distance(a, a.reversed()), 1e-9);
		assertEquals(25, EqualArcDistance.mean(a, a.reversed()), 1);
		assertTrue(DynamicTimeWarping.normalised(a, a.reversed()) > 10);
	}

	@Test
	void equalArcComparesTheShorterLength() {
		final Polyline a = Drawn.line(0, 0, 50, 0), b = Drawn.line(0, 0, 30, 0);
		assertEquals(0, EqualArcDistance.mean(a, b), 1e-12);
		final double[] t = IntStream.rangeClosed(0, 30).mapToDouble(i -> i).toArray();
		assertEquals(0, EqualArcDistance.mean(Polyline.of(t, new double[31]), a), 1e-12);
	}
}
