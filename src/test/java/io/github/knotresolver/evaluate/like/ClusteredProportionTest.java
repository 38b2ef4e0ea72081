package io.github.knotresolver.evaluate.like;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;

import org.junit.jupiter.api.Test;

class ClusteredProportionTest {

	@Test
	void singleFramesGiveWilsonsInterval() {
		final int[] one = new int[100], hit = new int[100];
		for (int i = 0; i < 100; i++) {
			one[i] = 1;
			hit[i] = i < 90 ? 1 : 0;
		}
		// Wilson's score interval of 90 of 100, by its formula.
		final ClusteredProportion p = ClusteredProportion.of(hit, one);
		assertEquals(90, p.percent(), 1e-9);
		assertEquals(82.56, p.low(), 0.01);
		assertEquals(94.48, p.high(), 0.01);
	}

	@Test
	void moviesThatFailAsAWholeTellLessThanTheirFramesWould() {
		final ClusteredProportion spread = ClusteredProportion.of(new int[]{80, 80, 80, 80, 80},
			new int[]{100, 100, 100, 100, 100});
		final ClusteredProportion whole = ClusteredProportion.of(new int[]{100, 100, 100, 100, 0},
			new int[]{100, 100, 100, 100, 100});
		assertEquals(spread.percent(), whole.percent(), 1e-9);
		assertTrue(whole.high() - whole.low() > 2 * (spread.high() - spread.low()));
		assertEquals(37.55, whole.low(), 0.01, "Wilson of 4 of 5");
	}

	@Test
	void everythingRightIsNotCertain() {
		final ClusteredProportion p = ClusteredProportion.of(new int[]{40, 40, 40},
			new int[]{40, 40, 40});
		assertEquals(100, p.high(), 1e-9);
		assertTrue(p.low() > 85 && p.low() < 97, "low " + p.low());
	}

	@Test
	void noFrameIsNoShare() {
		assertTrue(Double.isNaN(ClusteredProportion.of(new int[2], new int[2]).percent()));
	}

	@Test
	void theIntervalHoldsTheShareOfSuchMoviesMostly() {
		for (long seed = 1; seed <= 3; seed++) {
			final Random random = new Random(seed);
			int held = 0;
			for (int trial = 0; trial < 400; trial++) {
				final int[] successes = new int[10], trials = new int[10];
				for (int m = 0; m < 10; m++) {
					// Movies differ: 0.9 on average, sd 0.09.
					final double p = 0.75 + 0.3 * random.nextDouble();
					for (int f = 0; f < 40; f++)
						successes[m] += random.nextDouble() < p ? 1 : 0;
					trials[m] = 40;
				}
				final ClusteredProportion p = ClusteredProportion.of(successes, trials);
				final double mean = 100 * (0.9 - 0.05 * 0.05 / 0.6);
				held += p.low() <= mean && mean <= p.high() ? 1 : 0;
			}
			assertTrue(held >= 360, "seed " + seed + ": holds in " + held + " of 400");
		}
	}
}
