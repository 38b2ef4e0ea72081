package io.github.knotresolver.fit;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;

import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.geometry.Polyline;

class FilamentEstimateTest {

	@Test
	void aFilamentLooksTheSameInOtherUnitsOfLight() {
		final FilamentEstimate known = new FilamentEstimate(
			new LineModel(LineModel.Kind.ADDITIVE, 1.5, 1, new double[]{1.2, 0.9, 0.3}), 64, 40,
			0.2, new Point(10, 20), true);
		final FilamentEstimate other = known.inUnitsOf(80);
		assertEquals(80, other.amplitude());
		assertArrayEquals(light(known), light(other), 0.1);
		assertEquals(known.length(), other.length());
		assertEquals(known.lengthError(), other.lengthError());
		assertEquals(known.fixedEnd(), other.fixedEnd());
		assertEquals(known.guessed(), other.guessed());
	}

	/** What a camera sees of it, in its own units. */
	private static double[] light(final FilamentEstimate filament) {
		final double[] pixels = ModelPicture
			.of(60, 40, filament.model(), Chain.along(
				Polyline.of(new double[]{10, 50}, new double[]{20, 20}), 20, filament.length()))
			.pixels().clone();
		for (int i = 0; i < pixels.length; i++)
			pixels[i] *= filament.amplitude();
		return pixels;
	}
}
