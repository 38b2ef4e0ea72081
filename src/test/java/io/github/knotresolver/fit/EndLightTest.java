package io.github.knotresolver.fit;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;

class EndLightTest {

	private static final double NOISE = 0.05;

	private static LineModel line(final LineModel.Kind kind) {
		return LineModel.uniform(kind, 1.5, 1);
	}

	private static EndLight light(final Chain truth, final LineModel model) {
		return new EndLight(DrawnMovie.draw(List.of(truth), List.of(), model, NOISE, 7).frame(0),
			model, NOISE);
	}

	@ParameterizedTest
	@EnumSource(LineModel.Kind.class)
	void aTipThatEndsInTheLightGrowsToItsEnd(final LineModel.Kind kind) {
		final Chain truth = DrawnMovie.wave(0, 80, 1);
		final EndLight light = light(truth, line(kind));
		assertTrue(light.beyondTip(truth.resized(60)).isThere());
		final Chain grown = light.settled(truth.resized(60));
		assertEquals(80, grown.length(), light.piece());
		assertTrue(grown.tip().distanceTo(truth.tip()) < light.piece());
	}

	@ParameterizedTest
	@EnumSource(LineModel.Kind.class)
	void aTipInTheDarkIsWithdrawn(final LineModel.Kind kind) {
		final Chain truth = DrawnMovie.wave(0, 60, 1);
		final EndLight light = light(truth, line(kind));
		assertTrue(light.beforeTip(truth.resized(80)).brightness() < 0.2);
		final Chain cut = light.settled(truth.resized(80));
		assertEquals(60, cut.length(), light.piece());
	}

	@ParameterizedTest
	@EnumSource(LineModel.Kind.class)
	void theOtherEndIsTreatedAlike(final LineModel.Kind kind) {
		final Chain truth = DrawnMovie.wave(0, 80, 1);
		final EndLight light = light(truth, line(kind));
		final Chain late = truth.reversed().resized(62).reversed();
		assertTrue(light.settled(late).start().distanceTo(truth.start()) < light.piece());
	}

	@ParameterizedTest
	@ValueSource(doubles = {0, 2, 5, 9})
	void aChainThatIsRightStaysAsItIs(final double t) {
		final Chain truth = DrawnMovie.wave(t, 80, 1.5);
		final EndLight light = light(truth, line(LineModel.Kind.ADDITIVE));
		final Chain settled = light.settled(truth);
		assertEquals(truth.length(), settled.length(), 1e-9);
		assertTrue(settled.distance(truth) < 1e-6);
		assertEquals(1, light.beforeTip(truth).brightness(), 0.15);
		assertTrue(!light.beyondTip(truth).isThere());
	}

	@Test
	void nothingIsSaidBeyondTheBorder() {
		final LineModel model = line(LineModel.Kind.ADDITIVE);
		final Chain truth = DrawnMovie.wave(0, 150, 0);
		final EndLight light = light(truth, model);
		final Chain leaving = truth.resized(90);
		assertTrue(leaving.tip().x() > DrawnMovie.SIZE - 4, leaving.tip().toString());
		final Chain outside = truth.resized(110);
		assertEquals(0, light.beyondTip(outside).sureness());
		assertSame(outside, light.settled(outside).length() == 110 ? outside : null);
	}

	@Test
	void hazeIsNoLine() {
		final LineModel model = line(LineModel.Kind.ADDITIVE);
		final Chain truth = DrawnMovie.wave(0, 60, 1);
		final NormalizedFrame dark = DrawnMovie.draw(List.of(truth), List.of(), model, NOISE, 7)
			.frame(0);
		final double[] pixels = dark.pixels().clone();
		for (int i = 0; i < pixels.length; i++) {
			final double x = i % dark.width() - truth.tip().x(),
				y = i / dark.width() - truth.tip().y();
			pixels[i] += 0.7 * Math.exp(-(x * x + y * y) / (2 * 12 * 12));
		}
		final EndLight light = new EndLight(
			new NormalizedFrame(dark.width(), dark.height(), pixels), model, NOISE);
		assertEquals(truth.length(), light.settled(truth).length(), 1e-9);
	}
}
