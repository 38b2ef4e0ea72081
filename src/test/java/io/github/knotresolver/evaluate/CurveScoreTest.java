package io.github.knotresolver.evaluate;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import io.github.knotresolver.geometry.Polyline;

class CurveScoreTest {

	private static final Polyline LINE = Polyline.of(new double[]{0, 10}, new double[]{0, 0});

	private static Polyline at(final double y) {
		return Polyline.of(new double[]{0, 10}, new double[]{y, y});
	}

	@Test
	void aCurveIsItsOwnPerfectResult() {
		final CurveScore s = CurveScore.of(LINE, LINE);
		assertEquals(1, s.dice());
		assertEquals(0, s.frechet());
		assertEquals(10, s.frechetReversed(), 1e-12);
		assertEquals(0, s.error(), 1e-12);
		assertEquals(0, s.lengthError());
		assertTrue(s.isResolved());
	}

	@Test
	void twoPixelsAsideStillCountAsFound() {
		assertEquals(1, CurveScore.of(LINE, at(2)).dice());
		assertEquals(0, CurveScore.of(LINE, at(2.001)).dice());
		assertEquals(2, CurveScore.of(LINE, at(2)).error(), 1e-12);
		assertEquals(2, CurveScore.of(LINE, at(2)).frechet(), 1e-12);
	}

	@Test
	void fivePixelsAsideAreNotResolved() {
		assertFalse(CurveScore.of(LINE, at(5)).isResolved());
		assertTrue(CurveScore.of(LINE, at(4.999)).isResolved());
	}

	@Test
	void halfACurveMissesTheOtherHalf() {
		final Polyline half = Polyline.of(new double[]{0, 5}, new double[]{0, 0});
		final CurveScore s = CurveScore.of(LINE, half);
		assertEquals(6, s.truePositives());
		assertEquals(0, s.falsePositives());
		assertEquals(3, s.falseNegatives());
		assertEquals(12 / 15.0, s.dice(), 1e-12);
		assertEquals(-50, s.lengthError(), 1e-12);
		assertEquals((1 + 2 + 3 + 4 + 5) / 11.0, s.miss(), 1e-12);
		assertEquals(0, s.error(), 1e-12);
	}

	@Test
	void swappedEndsAreSeen() {
		final CurveScore s = CurveScore.of(LINE, LINE.reversed());
		assertTrue(s.isFlipped());
		assertEquals(1, s.dice());
	}

	@Test
	void aPointIsNoContour() {
		final Polyline point = LINE.head(0);
		assertEquals("Contours to compare must be longer than 0 pixels, but are 10.0 and 0.0.",
			assertThrows(IllegalArgumentException.class, () -> CurveScore.of(LINE, point))
				.getMessage());
	}

	@ParameterizedTest
	@ValueSource(longs = {1, 2, 3, 4, 5, 6, 7, 8})
	void agreesWithBruteForceOnSmallCurves(final long seed) {
		final Random random = new Random(seed);
		final Polyline a = wiggle(random), b = wiggle(random);
		final CurveScore s = CurveScore.of(a, b);
		final Polyline t = a.resampled(1), r = b.resampled(1);
		final String message = "seed " + seed;
		assertEquals(leash(t, r, 0, 0), s.frechet(), 1e-9, message);
		int found = 0, missed = 0;
		for (int i = 0; i < r.size(); i++)
			if (nearest(r, i, t) <= 2)
				found++;
		for (int i = 0; i < t.size(); i++)
			if (nearest(t, i, r) > 2)
				missed++;
		assertEquals(2.0 * found / (found + r.size() + missed), s.dice(), 1e-12, message);
		double error = 0;
		for (int i = 0; i < r.size(); i++)
			error += nearest(r, i, a.resampled(0.1)) / r.size();
		assertEquals(error, s.error(), 1e-9, message);
	}

	private static Polyline wiggle(final Random random) {
		final double[] x = new double[5], y = new double[5];
		for (int i = 0; i < 5; i++) {
			x[i] = 2 * i + random.nextDouble();
			y[i] = 3 * random.nextDouble();
		}
		return Polyline.of(x, y);
	}

	private static double nearest(final Polyline from, final int i, final Polyline to) {
		double best = Double.POSITIVE_INFINITY;
		for (int j = 0; j < to.size(); j++)
			best = Math.min(best, from.point(i).distanceTo(to.point(j)));
		return best;
	}

	/** Tries every pair of walks. */
	private static double leash(final Polyline a, final Polyline b, final int i, final int j) {
		final double here = a.point(i).distanceTo(b.point(j));
		final boolean aEnds = i == a.size() - 1, bEnds = j == b.size() - 1;
		if (aEnds && bEnds)
			return here;
		double rest = Double.POSITIVE_INFINITY;
		if (!aEnds)
			rest = Math.min(rest, leash(a, b, i + 1, j));
		if (!bEnds)
			rest = Math.min(rest, leash(a, b, i, j + 1));
		if (!aEnds && !bEnds)
			rest = Math.min(rest, leash(a, b, i + 1, j + 1));
		return Math.max(here, rest);
	}
}
