package io.github.knotresolver.track;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;
import java.util.stream.IntStream;

import org.junit.jupiter.api.Test;

class SceneLengthsTest {

	@Test
	void halvesThatWereExchangedShowAsAStepOfTheLength() {
		final SceneLengths.LengthStep step = SceneLengths.step(lengths(2.4)).orElseThrow();
		assertEquals(100, step.before(), 0.3);
		assertEquals(102.4, step.after(), 0.3);
	}

	@Test
	void noiseAndSingleStraysAreNoStep() {
		final double[] lengths = lengths(0);
		assertTrue(SceneLengths.step(lengths).isEmpty());
		lengths[3] += 30;
		lengths[17] -= 20;
		assertTrue(SceneLengths.step(lengths).isEmpty());
	}

	@Test
	void aStepShowsWhereLengthsScatterOnOneSideOnly() {
		final double[] lengths = lengths(0);
		for (int i = 0; i < 7; i++)
			lengths[i] += 1 + i % 3;
		assertTrue(SceneLengths.step(lengths).isPresent());
	}

	@Test
	void fewLengthsSayNothing() {
		assertTrue(SceneLengths.step(new double[]{100, 100, 100, 110, 110, 110}).isEmpty());
	}

	@Test
	void onlyStepsOfTheSameSizeTheOtherWayBalance() {
		final SceneLengths.LengthStep step = new SceneLengths.LengthStep(100, 102.5);
		assertTrue(step.balances(new SceneLengths.LengthStep(133, 130.2)));
		assertFalse(step.balances(new SceneLengths.LengthStep(133, 135.5)));
		assertFalse(step.balances(new SceneLengths.LengthStep(133, 128)));
	}

	/** 24 lengths that scatter by 0.3 px, with a step in the middle. */
	private static double[] lengths(final double step) {
		final Random random = new Random(5);
		return IntStream.range(0, 24)
			.mapToDouble(i -> 100 + 0.3 * random.nextGaussian() + (i < 12 ? 0 : step)).toArray();
	}
}
