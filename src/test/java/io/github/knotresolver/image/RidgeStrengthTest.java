package io.github.knotresolver.image;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;

import net.imglib2.img.Img;
import net.imglib2.type.numeric.real.FloatType;

import org.apache.commons.math3.distribution.PoissonDistribution;
import org.apache.commons.math3.random.Well19937c;
import org.apache.commons.math3.stat.descriptive.moment.Mean;
import org.apache.commons.math3.stat.descriptive.moment.StandardDeviation;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** The unit of ridge strength is its own noise. */
class RidgeStrengthTest {

	private static final int SIZE = 192;

	@ParameterizedTest
	@CsvSource({"0.8,1", "1.07,7", "1.5,7", "2.8,40"})
	void eachDirectionHasStandardDeviationOneInGaussianNoise(final double sigma,
		final double noise) {
		final Random random = new Random(1);
		final float[] frame = new float[SIZE * SIZE];
		for (int i = 0; i < frame.length; i++)
			frame[i] = (float) (100 + noise * random.nextGaussian());
		assertEquals(1, spreadOfADirection(frame, sigma), 0.12);
	}

	@ParameterizedTest
	@ValueSource(doubles = {2, 20, 400})
	void eachDirectionHasStandardDeviationOneInPoissonNoise(final double mean) {
		final PoissonDistribution photons = new PoissonDistribution(new Well19937c(1), mean, 1e-9,
			10000);
		final float[] frame = new float[SIZE * SIZE];
		for (int i = 0; i < frame.length; i++)
			frame[i] = photons.sample();
		assertEquals(1, spreadOfADirection(frame, 1.2), 0.1);
	}

	/** Where direction 0 is taken alone: its response over the noise that all were given. */
	private static double spreadOfADirection(final float[] frame, final double sigma) {
		final Hessian hessian = Hessian.of(frame, SIZE, sigma);
		final RidgeStrength ridges = RidgeStrength.of(hessian, sigma);
		final float[] response = RidgeStrength.inDirection(hessian, sigma, 0);
		final double[] z = new double[response.length];
		for (int i = 0; i < z.length; i++)
			z[i] = response[i] / ridges.noise(i);
		assertEquals(0, new Mean().evaluate(z), 0.05);
		return new StandardDeviation().evaluate(z);
	}

	@Test
	void noiseIsThatOfThePlace() {
		final Random random = new Random(2);
		final float[] frame = new float[4 * SIZE * SIZE];
		for (int i = 0; i < frame.length; i++)
			frame[i] = (float) ((i % (2 * SIZE) < SIZE ? 5 : 11) * random.nextGaussian());
		final Img<FloatType> z = RidgeStrength.ofNoise(Pixels.image(frame, 2 * SIZE), 1.2);
		assertEquals(1, mean(z, 0, SIZE - 40), 0.1);
		assertEquals(1, mean(z, SIZE + 40, 2 * SIZE), 0.1);
	}

	private static double mean(final Img<FloatType> image, final int from, final int to) {
		double sum = 0;
		for (int y = 0; y < image.dimension(1); y++)
			for (int x = from; x < to; x++)
				sum += image.getAt(x, y).get();
		return sum / (to - from) / image.dimension(1);
	}

	@ParameterizedTest
	@ValueSource(doubles = {0, 0.3, 0.8, 1.2, 2.0, 2.9})
	void aLineIsStrongAlongItselfAndSlopesAreNothing(final double angle) {
		final float[] line = new float[SIZE * SIZE], slope = new float[SIZE * SIZE];
		for (int i = 0; i < line.length; i++) {
			final double x = i % SIZE - SIZE / 2, y = i / SIZE - SIZE / 2;
			final double d = y * Math.cos(angle) - x * Math.sin(angle);
			line[i] = (float) (100 * Math.exp(-d * d / 4));
			slope[i] = (float) (3 * x - 2 * y);
		}
		final RidgeStrength ridges = RidgeStrength.of(Hessian.of(line, SIZE, 1.4), 1.4);
		final int middle = SIZE / 2 * SIZE + SIZE / 2;
		// Of a Gaussian line of height h and variance v: h v^0.5 / (v + s^2)^1.5.
		final double strength = 100 * Math.sqrt(2) / Math.pow(2 + 1.4 * 1.4, 1.5);
		assertEquals(strength, ridges.strength(middle), 0.1 * strength);
		final double off = Math.abs(ridges.angle(middle) - angle);
		assertTrue(Math.min(off, Math.PI - off) <= Math.PI / 16 + 1e-6, "off by " + off);
		final RidgeStrength flat = RidgeStrength.of(Hessian.of(slope, SIZE, 1.4), 1.4);
		assertEquals(0, flat.strength(middle), 1e-3);
	}
}
