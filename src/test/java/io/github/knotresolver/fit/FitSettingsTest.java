package io.github.knotresolver.fit;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

class FitSettingsTest {

	@Test
	void bendingCostsTheSameShareOfTheNoise() {
		final FitSettings free = FitSettings.ENDS_FREE;
		final double half = free.inNoise(0.15, 0.3).stiffness();
		assertEquals(FitSettings.NOISY_STIFFNESS / 4, half, 1e-9);
		assertEquals(4 / 2.25 * half, free.inNoise(0.2, 0.3).stiffness(), 1e-9);
		assertEquals(free, free.inNoise(0.1, 0.3));
		assertFalse(free.inNoise(0.29, 0.3).isNoisy());
		assertTrue(free.inNoise(0.4, 0.3).isNoisy());
		assertEquals(FitSettings.NOISY_STIFFNESS, free.inNoise(0.4, 0.3).stiffness());
	}
}
