
package io.github.knotresolver.measure;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

import org.junit.jupiter.api.Test;

import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.model.Calibration;

class GlidingTest {

	private static final Calibration MICROSCOPE = new Calibration(0.1, "µm", 0.5, "s");

	/** A quarter of a ring of radius 40, that far along it. */
	private static Polyline onRing(final double along) {
		final double[] x = new double[80], y = new double[80];
		for (int i = 0; i < x.length; i++) {
			final double angle = (along + i) / 40;
			x[i] = 60 + 40 * Math.cos(angle);
			y[i] = 60 + 40 * Math.sin(angle);
		}
		return Polyline.of(x, y);
	}

	@Test
	void pathAndSpeedAreThoseAlongTheTrack() {
		final List<Optional<Polyline>> contours = new ArrayList<>();
		for (int t = 0; t < 21; t++)
			contours.add(t == 10 ? Optional.empty() : Optional.of(onRing(2 * t)));
		final Gliding gliding = Gliding.of(contours, MICROSCOPE).orElseThrow();
		assertEquals(18, gliding.steps());
		assertEquals(18 * 0.2, gliding.path(), 0.01);
		assertEquals(0.4, gliding.speed(), 0.002);
	}

	@Test
	void whatMovesSidewaysOrToAndFroDoesNotGlide() {
		final List<Optional<Polyline>> sideways = new ArrayList<>(), toAndFro = new ArrayList<>();
		for (int t = 0; t < 9; t++) {
			sideways.add(Optional
				.of(Polyline.of(new double[]{10, 50}, new double[]{10 + 3 * t, 10 + 3 * t})));
			toAndFro.add(Optional.of(onRing(t % 2)));
		}
		assertEquals(0, Gliding.of(sideways, MICROSCOPE).orElseThrow().path(), 1e-9);
		assertEquals(0, Gliding.of(toAndFro, MICROSCOPE).orElseThrow().path(), 1e-3);
	}

	@Test
	void withoutTwoNeighbouringContoursThereIsNone() {
		assertTrue(
			Gliding.of(List.of(Optional.of(onRing(0)), Optional.empty(), Optional.of(onRing(4))),
				MICROSCOPE).isEmpty());
	}
}
