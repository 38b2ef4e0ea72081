package io.github.knotresolver.fit;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Random;

import org.junit.jupiter.api.Test;

class BleachingTest {

	@Test
	void findsTheRateAmongOutliers() {
		final Random random = new Random(3);
		final double[] brightness = new double[60];
		for (int t = 0; t < brightness.length; t++)
			brightness[t] = 100 * Math.exp(-0.01 * t) * (1 + 0.03 * random.nextGaussian());
		for (int t = 20; t < 32; t++)
			brightness[t] *= 2;
		brightness[5] = Double.NaN;
		final Bleaching bleaching = Bleaching.learn(brightness);
		assertEquals(0.01, bleaching.rate(), 0.001);
		assertEquals(Math.exp(-0.1), bleaching.factor(10), 0.01);
	}

	@Test
	void leavesSteadyLightAlone() {
		assertEquals(1, Bleaching.learn(new double[]{1, 1.01, 0.99, 1, 1.02}).factor(4));
		assertEquals(0, Bleaching.learn(new double[]{1}).rate());
		assertEquals(0, Bleaching.learn(new double[]{Double.NaN, 0, -1}).rate());
	}

	/** Pairs of all frames of a long movie are more than an array can hold. */
	@Test
	void learnsFromMoviesOfAnyLength() {
		final double[] brightness = new double[100_000];
		for (int t = 0; t < brightness.length; t++)
			brightness[t] = 100 * Math.exp(-1e-4 * t);
		assertEquals(1e-4, Bleaching.learn(brightness).rate(), 1e-9);
	}
}
