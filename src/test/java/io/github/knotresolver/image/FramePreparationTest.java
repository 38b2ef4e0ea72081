package io.github.knotresolver.image;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;

import org.junit.jupiter.api.Test;

/** Hot pixels, blocks, background. */
class FramePreparationTest {

	@Test
	void aHotPixelGoesAndAThinLineStays() {
		final float[] frame = new float[9 * 9];
		for (int i = 0; i < 9; i++)
			frame[i * 9 + 4] = 10;
		final float[] line = frame.clone();
		frame[2 * 9 + 1] = 400;
		frame[6 * 9 + 7] = -400;
		final float[] clipped = HotPixels.clip(frame, 9);
		for (int i = 0; i < line.length; i++)
			assertEquals(line[i], clipped[i], "pixel " + i);
	}

	@Test
	void aDiagonalLineStays() {
		final float[] frame = new float[9 * 9];
		for (int i = 0; i < 9; i++)
			frame[i * 9 + i] = 10;
		final float[] clipped = HotPixels.clip(frame, 9);
		for (int i = 1; i < 8; i++)
			assertEquals(10, clipped[i * 9 + i]);
	}

	@Test
	void blocksAreMeansAndWhatDoesNotFillOneIsLeftOut() {
		final float[] binned = Binning.mean(new float[]{1, 3, 9, 5, 7, 9, 0, 0, 0}, 3, 2);
		assertEquals(1, binned.length);
		assertEquals(4, binned[0]);
		assertThrows(IllegalArgumentException.class, () -> Binning.mean(new float[4], 2, 3));
	}

	@Test
	void backgroundRunsOnUnderALineOnASlope() {
		final int size = 120;
		final Random random = new Random(3);
		final float[] frame = new float[size * size];
		final boolean[] mask = new boolean[frame.length];
		for (int i = 0; i < frame.length; i++) {
			final double d = i / size - 60;
			frame[i] = (float) (slope(i % size) + 100 * Math.exp(-d * d / 4)
				+ 4 * random.nextGaussian());
			mask[i] = Math.abs(d) < 6;
		}
		final float[] background = Background.of(frame, size, mask);
		for (int x = 10; x < 110; x++)
			assertEquals(slope(x), background[60 * size + x], 3, "column " + x);
	}

	/** Where pixels of the background lie on one side only, a local mean is off by what they miss. */
	@Test
	void backgroundOfASteepBowIsRightAtTheBorderAndInsideARing() {
		final int size = 120;
		final Random random = new Random(3);
		final float[] frame = new float[size * size];
		final boolean[] mask = new boolean[frame.length];
		for (int i = 0; i < frame.length; i++) {
			final double d = Math.hypot(i % size - 30, i / size - 60) - 18;
			frame[i] = (float) (bow(i % size, i / size) + 100 * Math.exp(-d * d / 4)
				+ 4 * random.nextGaussian());
			mask[i] = Math.abs(d) < 8;
		}
		final float[] background = Background.of(frame, size, mask);
		for (int i = 0; i < frame.length; i++)
			assertEquals(bow(i % size, i / size), background[i], 3,
				"column " + i % size + ", row " + i / size);
	}

	private static double bow(final int x, final int y) {
		return 20 + 8 * x + 0.05 * (y - 40) * (y - 40);
	}

	private static double slope(final int x) {
		return 20 + 160 * x / 120.0;
	}

	@Test
	void backgroundOfNothingButLinesIsTheirMeanAndOfMissingPixelsNothing() {
		final float[] frame = {1, 3, Float.NaN, 5};
		final float[] background = Background.of(frame, 2, new boolean[4]);
		for (final float b : background)
			assertEquals(3, b, 1e-6);
		assertTrue(
			Float.isFinite(Background.of(frame, 2, new boolean[]{true, true, true, true})[0]));
	}
}
