package io.github.knotresolver.evaluate;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Random;

import org.junit.jupiter.api.Test;

import io.github.knotresolver.geometry.Polyline;

class SkeletonScoreTest {

	private static final Polyline LINE = Polyline.of(new double[]{0, 10}, new double[]{0, 0});

	@Test
	void orderDoesNotCount() {
		final SkeletonScore s = SkeletonScore.of(LINE,
			new double[]{7, 3, 0, 9, 1, 5, 10, 2, 8, 4, 6}, new double[11]);
		assertEquals(1, s.dice());
		assertArrayEquals(new double[11], s.errors(), 1e-12);
	}

	@Test
	void specksAreFalseAndGapsAreMissing() {
		final SkeletonScore s = SkeletonScore.of(LINE, new double[]{0, 1, 2, 30},
			new double[]{0, 1, 0, 0});
		// found: 3 of 4; not covered: 5 to 10
		assertEquals(6.0 / (6 + 1 + 6), s.dice(), 1e-12);
		assertArrayEquals(new double[]{0, 1, 0, 20}, s.errors(), 1e-12);
	}

	@Test
	void noSkeletonIsNothing() {
		final SkeletonScore s = SkeletonScore.of(LINE, new double[0], new double[0]);
		assertEquals(0, s.dice());
		assertEquals(0, s.errors().length);
	}

	@Test
	void agreesWithTheScoreOfCurves() {
		final long seed = 8;
		final Random random = new Random(seed);
		final double[] x = new double[40], y = new double[40];
		for (int i = 1; i < x.length; i++) {
			x[i] = x[i - 1] + random.nextDouble();
			y[i] = y[i - 1] + random.nextGaussian();
		}
		final Polyline truth = Polyline.of(x, y);
		for (int i = 0; i < x.length; i++)
			y[i] += 1.5 * random.nextGaussian();
		final Polyline result = Polyline.of(x, y);
		final Polyline points = result.resampled(1);
		final SkeletonScore s = SkeletonScore.of(truth, points.xs(), points.ys());
		assertEquals(CurveScore.of(truth, result).dice(), s.dice(), "seed " + seed);
		assertArrayEquals(CurveScore.positionErrors(truth, result), s.errors(), "seed " + seed);
	}
}
