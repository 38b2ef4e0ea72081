package io.github.knotresolver.geometry;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.stream.IntStream;

import org.junit.jupiter.api.Test;

class GaussianSmoothingTest {

	@Test
	void straightLineStaysAsItIs() {
		final Polyline line = Polyline.of(IntStream.range(0, 20).mapToDouble(i -> 3 + i).toArray(),
			IntStream.range(0, 20).mapToDouble(i -> 2 * i).toArray());
		final Polyline smooth = GaussianSmoothing.gaussian(line, 2);
		for (int i = 0; i < line.size(); i++)
			assertEquals(0, line.point(i).distanceTo(smooth.point(i)), 1e-9);
	}

	@Test
	void endsStayAndStaircaseVanishes() {
		final Polyline stairs = Polyline.of(IntStream.range(0, 61).mapToDouble(i -> i).toArray(),
			IntStream.range(0, 61).mapToDouble(i -> i / 3).toArray());
		final Polyline smooth = GaussianSmoothing.gaussian(stairs, 1.5);
		assertEquals(stairs.first(), smooth.first());
		assertEquals(stairs.last(), smooth.last());
		assertEquals(Math.hypot(60, 20), smooth.length(), 0.3);
		assertTrue(stairs.length() > smooth.length() + 3);
	}

	@Test
	void circleShrinksAsStated() {
		final int n = 200;
		final double r = n / (2 * Math.PI);
		final Polyline arc = Polyline.of(
			IntStream.range(0, n).mapToDouble(i -> r * Math.cos(i / r)).toArray(),
			IntStream.range(0, n).mapToDouble(i -> r * Math.sin(i / r)).toArray());
		final Point middle = GaussianSmoothing.gaussian(arc, 2).point(n / 2);
		assertEquals(r - 4 / (2 * r), Math.hypot(middle.x(), middle.y()), 2e-3);
	}

	@Test
	void shortCurvesAndBadSigma() {
		final Polyline two = Polyline.of(new double[]{0, 1}, new double[]{0, 0});
		assertEquals(two, GaussianSmoothing.gaussian(two, 2));
		assertThrows(IllegalArgumentException.class, () -> GaussianSmoothing.gaussian(two, 0));
	}

	@Test
	void everyStepIsExact() {
		final Polyline line = Polyline.of(new double[]{0, 10.7}, new double[]{0, 0});
		final Polyline sampled = line.every(4);
		assertEquals(3, sampled.size());
		assertEquals(8, sampled.x(2), 1e-12);
		assertEquals(1, line.every(11).size());
		assertThrows(IllegalArgumentException.class, () -> line.every(0));
	}
}
