package io.github.knotresolver.image;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Arrays;
import java.util.Random;

import org.junit.jupiter.api.Test;

class NoiseTest {

	private static final int WIDTH = 80, HEIGHT = 60;

	@Test
	void noiseIsToldFromSlopeLinesAndMissingPixels() {
		final Random random = new Random(12);
		final double[] pixels = new double[WIDTH * HEIGHT];
		for (int i = 0; i < pixels.length; i++)
			pixels[i] = 0.5 * (i % WIDTH) + 7 * random.nextGaussian() + (i / WIDTH == 30 ? 200 : 0)
				+ (i % WIDTH == 10 ? 300 : 0);
		Arrays.fill(pixels, 5 * WIDTH, 7 * WIDTH, Double.NaN);
		assertEquals(7, PixelNoise.of(pixels, WIDTH), 0.5);
		assertEquals(0, PixelNoise.of(new double[WIDTH], WIDTH));
		assertEquals(0, PixelNoise.of(new double[3], 1));
	}

	@Test
	void blurKeepsLightAndSpreadsAPoint() {
		final float[] point = new float[WIDTH * HEIGHT];
		point[20 * WIDTH + 30] = 100;
		final float[] blurred = GaussianBlur.blur(point, WIDTH, 1.5);
		double sum = 0, spread = 0;
		for (int i = 0; i < blurred.length; i++) {
			sum += blurred[i];
			spread += blurred[i] * Math.pow(i % WIDTH - 30, 2);
		}
		assertEquals(100, sum, 1e-3);
		assertEquals(1.5 * 1.5, spread / sum, 0.01);
		final float[] flat = new float[WIDTH * HEIGHT];
		Arrays.fill(flat, 3);
		assertArrayEquals(flat, GaussianBlur.blur(flat, WIDTH, 1.5), 1e-5f);
	}
}
