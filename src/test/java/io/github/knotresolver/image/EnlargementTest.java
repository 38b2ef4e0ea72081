package io.github.knotresolver.image;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class EnlargementTest {

	private static final int SIZE = 48;

	private static float[] noise() {
		final Random random = new Random(4);
		final float[] noise = new float[SIZE * SIZE];
		for (int i = 0; i < noise.length; i++)
			noise[i] = Math.round(100 + 10 * random.nextGaussian());
		return noise;
	}

	@Test
	void aCamerasPictureIsNotEnlarged() {
		assertFalse(Enlargement.of(noise(), SIZE).isEnlarged());
		assertFalse(Enlargement.of(new float[SIZE * SIZE], SIZE).isEnlarged());
	}

	@ParameterizedTest
	@ValueSource(ints = {2, 3, 5, 8})
	void blocksAreCounted(final int factor) {
		final float[] small = noise();
		final int width = SIZE * factor;
		final float[] large = new float[width * width];
		for (int i = 0; i < large.length; i++)
			large[i] = small[i / width / factor * SIZE + i % width / factor];
		assertEquals(new Enlargement(factor, false), Enlargement.of(large, width));
	}

	@Test
	void interpolatedPixelsShareTheirNoise() {
		final float[] small = noise();
		final int width = 4 * SIZE;
		final float[] large = new float[width * width];
		for (int i = 0; i < large.length; i++)
			large[i] = (float) Pixels.between(small, SIZE, i % width / 4.0, i / width / 4.0);
		assertTrue(Enlargement.of(large, width).smooth());
	}
}
