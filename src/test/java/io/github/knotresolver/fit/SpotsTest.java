package io.github.knotresolver.fit;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;

import org.junit.jupiter.api.Test;

import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.geometry.Polyline;

class SpotsTest {

	private static final int SIZE = 60, MIDDLE = SIZE / 2;

	private static final double SIGMA = 1.5, NEAR = 8;

	private static final LineModel LINE = LineModel.uniform(LineModel.Kind.ADDITIVE, SIGMA, 1);

	private static NormalizedFrame bead(final double height) {
		final double[] pixels = new double[SIZE * SIZE];
		for (int i = 0; i < pixels.length; i++)
			pixels[i] = height * Math.exp(-(Math.pow(i % SIZE - MIDDLE, 2)
				+ Math.pow(i / SIZE - MIDDLE, 2)) / (2 * 1.3 * 1.3 * SIGMA * SIGMA));
		return new NormalizedFrame(SIZE, SIZE, pixels);
	}

	private static double[] line() {
		return ChainPixels.draw(new NormalizedFrame(SIZE, SIZE, new double[SIZE * SIZE]), LINE,
			Chain.along(Polyline.of(List.of(new Point(12, 20), new Point(48, 33))), 20, 38));
	}

	@Test
	void aBeadIsTakenOff() {
		final NormalizedFrame bead = bead(1.5);
		final Spots spots = Spots.in(bead, SIGMA, List.of(), NEAR);
		assertFalse(spots.isEmpty());
		final NormalizedFrame rest = spots.takenOff(bead.rescaled(0, 0.02), 50);
		for (final double left : rest.pixels())
			assertEquals(0, left, 0.1 * 50);
		assertFalse(rest.hides(MIDDLE * SIZE + MIDDLE, 1000));
	}

	@Test
	void whereABeadDazzlesNothingIsKnown() {
		final NormalizedFrame rest = Spots.in(bead(20), SIGMA, List.of(), NEAR)
			.takenOff(bead(20), 1);
		final int middle = MIDDLE * SIZE + MIDDLE;
		assertEquals(0, rest.residual(middle, rest.pixels()[middle], 0));
		assertEquals(0, rest.residual(middle, rest.pixels()[middle], 1));
		assertEquals(-1, rest.residual(0, rest.pixels()[0], 1), "far away it is known that nothing is there");
	}

	@Test
	void aLineThatWasMissedIsNoSpot() {
		assertTrue(Spots.in(new NormalizedFrame(SIZE, SIZE, line()), SIGMA, List.of(), NEAR)
			.isEmpty());
	}

	@Test
	void lightAtAnEndOfTheFilamentIsItsOwn() {
		assertTrue(
			Spots.in(bead(1.5), SIGMA, List.of(new Point(MIDDLE + 4, MIDDLE)), NEAR).isEmpty());
	}
}
