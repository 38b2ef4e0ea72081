package io.github.knotresolver.track;

import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;
import java.util.stream.IntStream;

import org.junit.jupiter.api.Test;

class SceneLengthsTest {

	@Test
	void halvesThatWereExchangedShowAsAStepOfTheLength() {
		assertTrue(SceneLengths.changes(lengths(2.4)));
	}

	@Test
	void noiseAndSingleStraysAreNoStep() {
		final double[] lengths = lengths(0);
		assertFalse(SceneLengths.changes(lengths));
		lengths[3] += 30;
		lengths[17] -= 20;
		assertFalse(SceneLengths.changes(lengths));
	}

	@Test
	void aStepShowsWhereLengthsScatterOnOneSideOnly() {
		final double[] lengths = lengths(0);
		for (int i = 0; i < 7; i++)
			lengths[i] += 1 + i % 3;
		assertTrue(SceneLengths.changes(lengths));
	}

	@Test
	void fewLengthsSayNothing() {
		assertFalse(SceneLengths.changes(new double[]{100, 100, 100, 110, 110, 110}));
	}

	/** 24 lengths that scatter by 0.3 px, with a step in the middle. */
	private static double[] lengths(final double step) {
		final Random random = new Random(5);
		return IntStream.range(0, 24)
			.mapToDouble(i -> 100 + 0.3 * random.nextGaussian() + (i < 12 ? 0 : step)).toArray();
	}
}
