package io.github.knotresolver.candidate;

import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

import io.github.knotresolver.geometry.Polyline;

class LikenessTest {

	private static Polyline line(final int points, final double dx, final double dy) {
		final double[] x = new double[points], y = new double[points];
		for (int i = 0; i < points; i++) {
			x[i] = dx + CandidateTuning.LIKENESS_STEP * i;
			y[i] = dy;
		}
		return Polyline.of(x, y);
	}

	@Test
	void walksAreAlikeThatAreNowhereFurtherApartThanTheFilamentIsWide() {
		final double limit = CandidateTuning.ALIKE;
		assertTrue(Likeness.alike(line(5, 0, 0), line(5, 0, 0)));
		assertTrue(Likeness.alike(line(5, 0, 0), line(5, 0, limit)));
		assertFalse(Likeness.alike(line(5, 0, 0), line(5, 0, 1.01 * limit)));
		assertFalse(Likeness.alike(line(5, 0, 0), line(5, 1.01 * limit, 0)));
		assertTrue(Likeness.alike(line(5, 2, 3), line(5, 2 + 0.6 * limit, 3 + 0.6 * limit)));
		assertFalse(Likeness.alike(line(5, 2, 3), line(5, 2 + 0.8 * limit, 3 + 0.8 * limit)));
	}

	@Test
	void walksOfDifferentLengthAreNotAlike() {
		assertTrue(Likeness.alike(line(5, 0, 0), line(6, 0, 0)));
		assertFalse(Likeness.alike(line(5, 0, 0), line(7, 0, 0)));
		assertFalse(Likeness.alike(line(7, 0, 0), line(5, 0, 0)));
	}

	/** The first point counts as much as any other. */
	@Test
	void everyPointIsCompared() {
		for (int apart = 0; apart < 5; apart++) {
			final double[] x = {0, 4, 8, 12, 16}, y = new double[5];
			y[apart] = 9;
			assertFalse(Likeness.alike(line(5, 0, 0), Polyline.of(x, y)), "point " + apart);
		}
	}
}
