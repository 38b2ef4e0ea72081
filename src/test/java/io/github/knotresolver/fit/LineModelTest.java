package io.github.knotresolver.fit;

import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

/** What a line says of its ends. */
class LineModelTest {

	private static final LineModel EVEN = LineModel.uniform(LineModel.Kind.ADDITIVE, 1.5, 1);

	@Test
	void anEndIsDimIfItLacksMuchOfTheUsualBrightness() {
		assertFalse(EVEN.hasDimEnd());
		assertFalse(EVEN.withBrightness(new double[]{1.2, 0.3, 0.8}).hasDimEnd());
		assertTrue(EVEN.withBrightness(new double[]{1.4, 1, 0.4}).hasDimEnd());
		assertTrue(EVEN.withBrightness(new double[]{0.4, 1, 1.4}).hasDimEnd());
	}

	@Test
	void aLineOfOneBrightnessIsEven() {
		assertTrue(EVEN.isEven());
		assertFalse(EVEN.withBrightness(new double[]{1.1, 0.9}).isEven());
	}
}
