package io.github.knotresolver.track;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Optional;

import org.junit.jupiter.api.Test;

import io.github.knotresolver.fit.FilamentEstimate;
import io.github.knotresolver.fit.LineModel;
import io.github.knotresolver.geometry.Point;

/** What open frames settle of a length. */
class LengthsTest {

	private static final FilamentEstimate ESTIMATE = new FilamentEstimate(
		LineModel.uniform(LineModel.Kind.ADDITIVE, 1.5, 1), 1, 150, Double.NaN, new Point(0, 0),
		false);

	private static double settled(final double... whole) {
		return new Lengths(whole, 0, 0, Optional.empty()).settle(ESTIMATE).length();
	}

	@Test
	void lengthsThatAgreeDecideAndOneThatDoesNotIsLeftOut() {
		assertEquals(160, settled(158, 159, 160, 161, 162, 300), 1);
	}

	/** Their median is between them, and none is near it. */
	@Test
	void asManyThatAreFarTooShortAsFarTooLongSayNothing() {
		assertEquals(150, settled(90, 91, 92, 210, 211, 212));
	}

	@Test
	void tooFewSayNothing() {
		assertEquals(150, settled(200));
	}

	@Test
	void aGuessRemainsOneUntilTheUserSaysMore() {
		final FilamentEstimate guess = ESTIMATE.orGuessed(true);
		assertTrue(
			new Lengths(new double[]{200}, 210, 1, Optional.empty()).settle(guess).guessed());
		assertTrue(new Lengths(new double[0], 0, 0, Optional.of(LengthCourse.constant(180, 3)))
			.settle(guess).guessed());
		assertFalse(guess.withLength(160).guessed());
	}

	@Test
	void aLengthIsAnotherIfItIsSurelyAndNoticeablyOff() {
		assertFalse(new Lengths.Common(152, 1).isOtherThan(150, Double.NaN));
		assertFalse(new Lengths.Common(150.4, 0.1).isOtherThan(150, Double.NaN));
		assertTrue(new Lengths.Common(152, 0.5).isOtherThan(150, Double.NaN));
		assertTrue(new Lengths.Common(149, 0.1).isOtherThan(150, Double.NaN));
	}

	/** What was a guess is given up for what is known, as far as that is another. */
	@Test
	void aGuessIsAnotherLengthIfThisOneIsKnownFarBetter() {
		assertTrue(new Lengths.Common(151, 0.5).isOtherThan(150, 1.1));
		assertFalse(new Lengths.Common(151, 0.5).isOtherThan(150, 0.9));
		assertFalse(new Lengths.Common(150.4, 0.5).isOtherThan(150, 1.1));
	}
}
