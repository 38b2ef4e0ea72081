
package io.github.knotresolver.image;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.Random;

import net.imglib2.img.array.ArrayImgs;
import net.imglib2.view.Views;

import org.junit.jupiter.api.Test;

import io.github.knotresolver.model.Cleaning;

class CleaningStepsTest {

	@Test
	void stretchSaturatesOnePercentAtBothEnds() {
		final float[] ramp = new float[101];
		for (int i = 0; i < ramp.length; i++)
			ramp[i] = 1000 + i;
		final float[] stretched = Pixels
			.floats(ContrastStretch.saturate(Pixels.image(ramp, 101), 1, 1));
		assertEquals(0, stretched[1]);
		assertEquals(0.5, stretched[50], 1e-6);
		assertEquals(1 / 98.0, stretched[2], 1e-6);
		assertEquals(1, stretched[99]);
		assertEquals(1, stretched[100]);
	}

	@Test
	void stretchIsTheSameForEveryBitDepth() {
		final byte[] bytes = new byte[600];
		new Random(3).nextBytes(bytes);
		final short[] shorts = new short[600];
		final double[] doubles = new double[600];
		for (int i = 0; i < bytes.length; i++) {
			shorts[i] = (short) (200 * (bytes[i] & 255) + 7);
			doubles[i] = 1e9 + (bytes[i] & 255);
		}
		final float[] expected = Pixels
			.floats(ContrastStretch.saturate(ArrayImgs.unsignedBytes(bytes, 30, 20), 1, 1));
		assertArrayEquals(expected,
			Pixels.floats(ContrastStretch.saturate(ArrayImgs.unsignedShorts(shorts, 30, 20), 1, 1)),
			1e-6f);
		assertArrayEquals(expected,
			Pixels.floats(ContrastStretch.saturate(ArrayImgs.doubles(doubles, 30, 20), 1, 1)),
			1e-6f);
	}

	@Test
	void constantFrameBecomesZero() {
		final float[] constant = new float[12];
		Arrays.fill(constant, 7);
		assertArrayEquals(new float[12],
			Pixels.floats(new FrameCleaner(new Cleaning(5, 1.5)).clean(Pixels.image(constant, 4))));
	}

	@Test
	void pixelsWithoutAValueAreBackground() {
		final float[] values = {Float.NaN, 1, 2, 3, Float.NaN, 5, Float.POSITIVE_INFINITY,
			Float.NEGATIVE_INFINITY};
		assertArrayEquals(new float[]{0, 0, .25f, .5f, 0, 1, 1, 0},
			Pixels.floats(ContrastStretch.saturate(Pixels.image(values, 4), 0, 0)));
		final float[] none = {Float.NaN, Float.NaN};
		assertArrayEquals(new float[2],
			Pixels.floats(ContrastStretch.saturate(Pixels.image(none, 2), 1, 1)));
	}

	@Test
	void tinyFilamentOnEmptyBackgroundIsNotLost() {
		final float[] values = new float[10000];
		values[77] = 5;
		assertEquals(1,
			Pixels.floats(ContrastStretch.saturate(Pixels.image(values, 100), 1, 1))[77]);
	}

	@Test
	void saturationOfEverythingIsRefused() {
		assertTrue(assertThrows(IllegalArgumentException.class,
			() -> ContrastStretch.saturate(Pixels.image(new float[4], 2), 50, 50)).getMessage()
			.contains("50.0"));
	}

	@Test
	void framesMayStartAnywhere() {
		final float[] values = {0, 1, 2, 3, 4, 5};
		assertArrayEquals(new float[]{0, 0.25f, 0.75f, 1},
			Pixels.floats(ContrastStretch.saturate(
				Views.interval(Pixels.image(values, 3), new long[]{1, 0}, new long[]{2, 1}), 0, 0)),
			1e-6f);
	}

	@Test
	void threeDimensionsAreRefused() {
		assertTrue(assertThrows(IllegalArgumentException.class,
			() -> new FrameCleaner(Cleaning.DEFAULT).clean(ArrayImgs.floats(3, 3, 3))).getMessage()
			.contains("one frame"));
	}

	@Test
	void medianAgreesWithSorting() {
		for (int seed = 0; seed < 30; seed++) {
			final Random random = new Random(seed);
			final int width = 1 + random.nextInt(9), height = 1 + random.nextInt(9);
			final float[] in = new float[width * height];
			for (int i = 0; i < in.length; i++)
				in[i] = random.nextInt(20);
			final float[] expected = new float[in.length];
			for (int i = 0; i < in.length; i++)
				expected[i] = sortedMedian(in, width, height, i);
			assertArrayEquals(expected,
				Pixels.floats(MedianFilter.median3x3(Pixels.image(in, width))), "seed " + seed);
		}
	}

	private static float sortedMedian(final float[] in, final int width, final int height,
		final int at) {
		final float[] nine = new float[9];
		for (int k = 0; k < 9; k++) {
			final int x = at % width + k % 3 - 1, y = at / width + k / 3 - 1;
			nine[k] = in[Math.min(Math.max(y, 0), height - 1) * width
				+ Math.min(Math.max(x, 0), width - 1)];
		}
		Arrays.sort(nine);
		return nine[4];
	}

	@Test
	void laplacianFindsARidgeOnASlope() {
		final int width = 40;
		final float[] values = new float[width * 30];
		for (int i = 0; i < values.length; i++)
			values[i] = (float) (0.02 * (i % width)
				+ 0.3 * Math.exp(-Math.pow(i / width - 14, 2) / 4.5));
		final float[] ridge = Pixels
			.floats(LaplacianOfGaussian.enhance(Pixels.image(values, width), 13, 1.5));
		for (int x = 8; x < width - 8; x++) {
			assertTrue(ridge[14 * width + x] > 0.8, "on the ridge at " + x);
			assertTrue(ridge[4 * width + x] < 0.02, "above it at " + x);
			assertTrue(ridge[24 * width + x] < 0.02, "below it at " + x);
		}
	}

	@Test
	void laplacianAgreesWithTheFullKernel() {
		final int width = 9, size = 5;
		final double sigma = 1.2;
		final Random random = new Random(11);
		final float[] in = new float[width * 7];
		for (int i = 0; i < in.length; i++)
			in[i] = random.nextFloat();
		final double[] response = new double[in.length];
		double highest = 0;
		for (int i = 0; i < in.length; i++) {
			response[i] = fullKernel(in, width, i, size, sigma);
			highest = Math.max(highest, response[i]);
		}
		final float[] actual = Pixels
			.floats(LaplacianOfGaussian.enhance(Pixels.image(in, width), size, sigma));
		for (int i = 0; i < in.length; i++)
			assertEquals(Math.max(0, response[i]) / highest, actual[i], 1e-5,
				"seed 11, pixel " + i);
	}

	/** Kernel k(x)g(y) + g(x)k(y) with k of zero sum, summed the slow way. */
	private static double fullKernel(final float[] in, final int width, final int at,
		final int size, final double sigma) {
		final double[] g = new double[size], k = new double[size];
		double sum = 0;
		for (int i = 0; i < size; i++)
			sum += g[i] = Math.exp(-Math.pow((i - size / 2) / sigma, 2) / 2);
		double mean = 0;
		for (int i = 0; i < size; i++) {
			g[i] /= sum;
			k[i] = g[i] * (sigma * sigma - Math.pow(i - size / 2, 2));
			mean += k[i] / size;
		}
		double response = 0;
		for (int i = 0; i < size; i++)
			for (int j = 0; j < size; j++) {
				final int x = Math.min(Math.max(at % width + i - size / 2, 0), width - 1);
				final int y = Math.min(Math.max(at / width + j - size / 2, 0),
					in.length / width - 1);
				response += in[y * width + x] * ((k[i] - mean) * g[j] + g[i] * (k[j] - mean));
			}
		return response;
	}
}
