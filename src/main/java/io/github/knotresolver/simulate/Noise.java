
package io.github.knotresolver.simulate;

import java.util.SplittableRandom;

/**
 * Random numbers that are the same on every machine. Not safe for several
 * threads.
 */
final class Noise {

	/** Variance of a sum of 64 fair bits and a uniform number of width 1. */
	private static final double SCALE = 1 / Math.sqrt(16 + 1 / 12.0);

	/** Above this mean a Poisson number is drawn as a Gaussian one. */
	private static final double LARGE_MEAN = 50;

	private final SplittableRandom random;

	Noise(final long seed) {
		random = new SplittableRandom(seed);
	}

	/** @return random numbers of one frame of a movie */
	static Noise ofFrame(final long seed, final int frame) {
		return new Noise(seed * 0x9E3779B97F4A7C15L + frame);
	}

	/** @return a number in 0 (included) to 1 (excluded) */
	double uniform() {
		return random.nextDouble();
	}

	/**
	 * A Gaussian number of mean 0 and variance 1, as the number of ones among 64
	 * bits, smeared to be continuous: excess kurtosis -0.03, within 8 sigma,
	 * integer arithmetic only.
	 *
	 * @return the number
	 */
	double gaussian() {
		return (Long.bitCount(random.nextLong()) - 32 + random.nextDouble() - 0.5) * SCALE;
	}

	/**
	 * A Poisson number; Gaussian with the same mean and variance above a mean of
	 * 50.
	 *
	 * @param mean the mean, at least 0
	 * @return the number, at least 0
	 */
	double poisson(final double mean) {
		if (mean > LARGE_MEAN)
			return Math.max(0, mean + Math.sqrt(mean) * gaussian());
		final double limit = StrictMath.exp(-mean);
		int count = -1;
		for (double product = 1; product > limit; count++)
			product *= random.nextDouble();
		return Math.max(0, count);
	}
}
