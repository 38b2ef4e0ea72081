package io.github.knotresolver.track;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Random;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import io.github.knotresolver.Drawn;
import io.github.knotresolver.fit.Chain;
import io.github.knotresolver.fit.Fit;
import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.geometry.Polyline;

class MotionPriceTest {

	private static final AnchorPath STILL = AnchorPath.still(new Point(0, 0), 6);

	private static final int LINKS = 40;
	private static final double LENGTH = 80;

	/** A stem of 40 px, then a small loop, to the left or to the right. */
	private static Chain loop(final double shift, final int way) {
		final double radius = 40 / (2 * Math.PI);
		final double[] xy = new double[2 * 42];
		xy[0] = 10;
		xy[1] = 50 + shift;
		for (int i = 0; i <= 40; i++) {
			final double a = 2 * Math.PI * i / 40;
			xy[2 * i + 2] = 50 + radius * Math.sin(a);
			xy[2 * i + 3] = 50 + shift + way * radius * (1 - Math.cos(a));
		}
		return Chain.along(Drawn.line(xy), LINKS, LENGTH);
	}

	private static Fit fit(final Chain chain, final double energy) {
		return new Fit(chain, energy, energy, 1);
	}

	@Test
	void aLoopRunTheOtherWayRoundIsDear() {
		final MotionPrice usual = new MotionPrice(5, 0.3);
		final Chain there = loop(0, 1), moved = loop(5, 1), other = loop(0, -1);
		assertTrue(there.distance(other) < 9, "the loops lie near each other");
		assertTrue(usual.between(there, other) > 5 * usual.between(there, moved),
			usual.between(there, other) + " for the other way round, " + usual.between(there, moved)
				+ " for usual motion");
	}

	@ParameterizedTest
	@ValueSource(longs = {1, 2, 3, 4, 5, 6, 7, 8})
	void theMoreUnusualMotionOrTurningTheDearer(final long seed) {
		final Random random = new Random(seed);
		final Chain a = random(random), b = random(random);
		double motion = 1 + 20 * random.nextDouble(), turn = 0.1 + random.nextDouble();
		double before = new MotionPrice(motion, turn).between(a, b);
		assertEquals(before, new MotionPrice(motion, turn).between(b, a), 1e-9,
			"both ways, seed " + seed);
		for (int i = 0; i < 4; i++) {
			motion /= 1.5;
			final double dearer = new MotionPrice(motion, turn).between(a, b);
			assertTrue(dearer > before, "less usual motion, seed " + seed);
			turn /= 1.5;
			before = new MotionPrice(motion, turn).between(a, b);
			assertTrue(before > dearer, "less usual turning, seed " + seed);
		}
		assertEquals(0, new MotionPrice(motion, turn).between(a, a), 1e-9, "seed " + seed);
	}

	@Test
	void usualMotionIsCheapAndWhatExceedsItIsNot() {
		final MotionPrice price = new MotionPrice(10, 100);
		final double one = price.between(loop(0, 1), loop(10, 1));
		final double two = price.between(loop(0, 1), loop(20, 1));
		assertTrue(one > 0 && two > 3 * one, one + " for usual motion, " + two + " for twice it");
	}

	@Test
	void usualMotionIsLearnedFromTheBestFitsAndStandsForMostFrames() {
		final Chain far = loop(40, -1);
		final List<List<Fit>> proposals = List.of(List.of(fit(far, 0), fit(loop(0, 1), -5)),
			List.of(fit(loop(4, 1), -5), fit(far, -4)), List.of(), List.of(fit(loop(8, 1), -5)),
			List.of(fit(loop(12, 1), -5)), List.of(fit(far, -5)));
		final MotionPrice learned = MotionPrice.learn(proposals, STILL);
		assertEquals(4, learned.usualMotion(), 1e-6);
		assertTrue(learned.usualTurn() > 0 && learned.usualTurn() < 0.1);
	}

	@Test
	void withoutMotionToLearnFromPricesAreFinite() {
		for (final List<List<Fit>> none : List.of(List.<List<Fit>>of(), List.of(List.<Fit>of()),
			List.of(List.of(fit(loop(0, 1), 0)), List.of(fit(loop(0, 1), 0)))))
			assertTrue(
				Double.isFinite(MotionPrice.learn(none, STILL).between(loop(0, 1), loop(30, -1))));
	}

	private static Chain random(final Random random) {
		final double[] xy = new double[12];
		for (int i = 0; i < 6; i++) {
			xy[2 * i] = 10 + 14 * i + 4 * random.nextDouble();
			xy[2 * i + 1] = 50 + 20 * random.nextGaussian();
		}
		final Polyline curve = Drawn.line(xy);
		return Chain.along(curve, LINKS, LENGTH);
	}
}
