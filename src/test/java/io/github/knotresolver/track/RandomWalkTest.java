package io.github.knotresolver.track;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.Random;
import java.util.function.IntToDoubleFunction;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class RandomWalkTest {

	private static final int FRAMES = 60;

	private static final double NOISE = 0.3;

	private static RandomWalk through(final IntToDoubleFunction truth, final long seed,
		final int... hidden) {
		final Random random = new Random(seed);
		final double[] seen = new double[FRAMES], noise = new double[FRAMES];
		for (int t = 0; t < FRAMES; t++) {
			seen[t] = truth.applyAsDouble(t) + NOISE * random.nextGaussian();
			noise[t] = NOISE;
		}
		for (final int t : hidden)
			seen[t] = Double.NaN;
		return RandomWalk.through(seen, noise);
	}

	private static double rms(final RandomWalk walk, final IntToDoubleFunction truth) {
		double sum = 0;
		for (int t = 0; t < FRAMES; t++)
			sum += Math.pow(walk.mean()[t] - truth.applyAsDouble(t), 2);
		return Math.sqrt(sum / FRAMES);
	}

	@ParameterizedTest
	@ValueSource(longs = {1, 2, 3, 4, 5})
	void whatStaysIsAveragedOverAllFrames(final long seed) {
		assertTrue(rms(through(t -> 50, seed), t -> 50) < 0.5 * NOISE, "seed " + seed);
	}

	@ParameterizedTest
	@ValueSource(longs = {1, 2, 3, 4, 5})
	void aDriftIsFollowedAndSmoothed(final long seed) {
		assertTrue(rms(through(t -> 50 + 0.2 * t, seed), t -> 50 + 0.2 * t) < NOISE,
			"seed " + seed);
	}

	@ParameterizedTest
	@ValueSource(longs = {1, 2, 3, 4, 5})
	void aJumpStaysAJump(final long seed) {
		final IntToDoubleFunction jump = t -> t < 35 ? 50 : 58;
		final RandomWalk walk = through(jump, seed);
		assertEquals(50, walk.mean()[34], 3 * NOISE, "seed " + seed);
		assertEquals(58, walk.mean()[35], 3 * NOISE, "seed " + seed);
	}

	@Test
	void jitterIsFollowedFrameByFrame() {
		final double[] jitter = new Random(3).doubles(FRAMES, -3, 3).toArray();
		assertTrue(rms(through(t -> jitter[t], 1), t -> jitter[t]) < 1.2 * NOISE);
	}

	@Test
	void whatIsNotSeenIsLessSure() {
		final double[] jitter = new Random(3).doubles(FRAMES, -3, 3).toArray();
		final RandomWalk walk = through(t -> jitter[t], 1, 20, 21, 22);
		assertTrue(walk.sd()[21] > 3 * walk.sd()[40], walk.sd()[21] + " " + walk.sd()[40]);
		assertTrue(Double.isFinite(walk.mean()[21]));
	}

	@Test
	void framesBeforeTheFirstAndAfterTheLastAreFilled() {
		final double[] seen = new double[10];
		Arrays.fill(seen, Double.NaN);
		seen[4] = 7;
		final double[] noise = new double[10];
		Arrays.fill(noise, 1);
		final RandomWalk walk = RandomWalk.through(seen, noise);
		assertEquals(7, walk.mean()[0], 1e-9);
		assertEquals(7, walk.mean()[9], 1e-9);
		seen[4] = Double.NaN;
		assertThrows(IllegalArgumentException.class, () -> RandomWalk.through(seen, noise));
	}
}
