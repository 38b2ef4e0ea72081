package io.github.knotresolver.fit;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

class NormalizedFrameTest {

	private static final LineModel ADDITIVE = LineModel.uniform(LineModel.Kind.ADDITIVE, 1.5, 1);
	private static final LineModel SATURATING = LineModel.uniform(LineModel.Kind.SATURATING, 1.5,
		2);

	/** The third and the fourth pixel are at what the camera can show at most. */
	private static NormalizedFrame clipped() {
		return new NormalizedFrame(3, 2, new double[]{0, 20, 60, 60, 30, 10})
			.withCeiling(new double[]{50, 50, 50, 50, 50, 50});
	}

	@Test
	void lightThatWasCutOffMayHaveBeenAnyBrighter() {
		final NormalizedFrame frame = clipped();
		assertEquals(0, frame.residual(2, 60, 90));
		assertEquals(15, frame.residual(2, 60, 45));
		assertEquals(-50, frame.residual(0, 0, 90), "what is dark cannot have been brighter");
		assertEquals(-10, frame.residual(1, 20, 30));
	}

	@Test
	void aLineThatSaturatesIsItselfCutOff() {
		assertEquals(-30, clipped().residual(2, 60, 90, SATURATING));
		assertEquals(0, clipped().residual(2, 60, 90, ADDITIVE));
	}

	@Test
	void whatIsKnownOfAFrameIsKnownOfItsPartsAndInAllUnits() {
		final NormalizedFrame part = clipped().withWidening(1.5).rescaled(10, 20).window(0, 1, 2,
			1);
		assertTrue(part.isClipped());
		assertEquals(1.5, part.widening());
		assertEquals(2, part.ceiling()[0]);
		assertTrue(part.hides(0, 2.1));
		assertFalse(part.hides(0, 1.9));
		assertEquals(2.25, ADDITIVE.in(part).sigma());
	}

	@Test
	void aCeilingHasAHeightForEveryPixel() {
		assertThrows(IllegalArgumentException.class, () -> clipped().withCeiling(new double[4]));
	}
}
