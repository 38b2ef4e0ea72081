
package io.github.knotresolver.measure;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.Random;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.model.Calibration;

class ContourGeometryTest {

	private static final Calibration MICRONS = new Calibration(0.1, "µm", 10, "s");

	@Test
	void lineHasItsLengthAndNoCurvature() {
		final Polyline line = Polyline.of(new double[]{0, 3, 6, 9, 12, 15},
			new double[]{0, 4, 8, 12, 16, 20});
		final ContourGeometry g = ContourGeometry.of(line, MICRONS);
		assertEquals(2.5, g.length(), 1e-9);
		assertEquals(2.5, g.endToEnd(), 1e-9);
		assertEquals(Math.atan2(4, 3), g.tipAngle(), 1e-9);
		for (final double k : g.curvature())
			assertEquals(0, k, 1e-6);
	}

	@ParameterizedTest
	@ValueSource(doubles = {10, 20, 50})
	void circleHasItsCurvatureAndTurnsOnce(final double radius) {
		final Polyline arc = Curves.circle(radius, 1.5 * Math.PI, 0, 1);
		final ContourGeometry g = ContourGeometry.of(arc, MICRONS);
		assertEquals(1.5 * Math.PI * radius * 0.1, g.length(), 0.002 * g.length());
		assertEquals(Math.PI / 2, g.tangentAngle()[0], 0.015);
		assertEquals(2 * Math.PI, g.tipAngle(), 0.015);
		for (int i = 0; i < g.size(); i++) {
			final boolean end = i < 6 || i >= g.size() - 6;
			assertEquals(10 / radius, g.curvature()[i], (end ? 0.12 : 0.03) * 10 / radius);
		}
	}

	/** y points down: from x towards y is positive, clockwise on the screen. */
	@Test
	void turningTowardsYIsPositive() {
		final Polyline arc = Curves.circle(20, 1, 0, 1);
		assertTrue(ContourGeometry.of(arc, MICRONS).curvature()[5] > 0);
		final Polyline mirrored = Polyline.of(arc.xs(),
			Arrays.stream(arc.ys()).map(y -> -y).toArray());
		assertTrue(ContourGeometry.of(mirrored, MICRONS).curvature()[5] < 0);
	}

	@ParameterizedTest
	@CsvSource({"0.1, 0.004", "0.3, 0.006"})
	void noisyCircleKeepsItsLengthAndCurvature(final double noise, final double tolerance) {
		double length = 0, curvature = 0;
		final int repeats = 40;
		for (int seed = 0; seed < repeats; seed++) {
			final ContourGeometry g = ContourGeometry.of(
				Curves.noisy(Curves.circle(30, 1.8 * Math.PI, 0, 1), noise, new Random(seed)),
				MICRONS);
			length += g.length() / (1.8 * Math.PI * 3) / repeats;
			for (final double k : g.curvature())
				curvature += k * 3 / g.size() / repeats;
		}
		assertEquals(1, length, tolerance);
		assertEquals(1, curvature, 0.025);
	}

	/** Chains of pixel centres are staircases; their length must not count. */
	@Test
	void staircaseOfPixelsHasTheLengthOfItsCurve() {
		double length = 0;
		for (int i = 0; i < 20; i++) {
			final Polyline pixels = Curves.pixels(Curves.circle(25 + 0.37 * i, 5, i, 0.2));
			length += ContourGeometry.of(pixels, Calibration.NONE).length() / (5 * (25 + 0.37 * i))
				/ 20;
		}
		assertEquals(1, length, 0.01);
	}

	@Test
	void defaultNeitherShortensNorAmplifies() {
		for (int seed = 0; seed < 10; seed++) {
			final Polyline truth = Curves.sine(120, 12, 60);
			final Polyline noisy = Curves.noisy(truth, 0.2, new Random(seed));
			final ContourGeometry exact = ContourGeometry.of(truth, MICRONS);
			final ContourGeometry g = ContourGeometry.of(noisy, MICRONS);
			assertEquals(truth.length() * 0.1, exact.length(), 1e-3 * exact.length());
			assertEquals(exact.length(), g.length(), 0.01 * exact.length(), "seed " + seed);
			double rms = 0;
			for (int i = 0; i < g.size(); i++)
				rms += Math.pow(g.curvature()[i] - exact.curvature()[i], 2) / g.size();
			assertTrue(Math.sqrt(rms) < 0.25, "seed " + seed + ": " + Math.sqrt(rms));
		}
	}

	@Test
	void contourOfTwoPointsIsRefusedInOneSentence() {
		final Polyline two = Polyline.of(new double[]{0, 1}, new double[]{0, 0});
		final String message = assertThrows(IllegalArgumentException.class,
			() -> ContourGeometry.of(two, MICRONS)).getMessage();
		assertTrue(message.contains("at least 3 points"), message);
		assertTrue(message.contains("has 2 points"), message);
	}

	@Test
	void contourWithRepeatedPointsIsMeasured() {
		final double[] x = {0, 0, 1, 2, 2, 2, 3, 4, 5, 6, 7, 8, 9, 10, 10};
		final ContourGeometry g = ContourGeometry.of(Polyline.of(x, new double[x.length]),
			Calibration.NONE);
		assertEquals(10, g.length(), 1e-6);
		assertEquals(x.length, g.size());
	}
}
