package io.github.knotresolver.image;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Arrays;
import java.util.Random;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** What works on whole rows says what the plain definition says, at every pixel and border. */
class RowKernelsTest {

	private static float[] drawn(final int width, final int height) {
		final Random random = new Random(31L * width + height);
		final float[] pixels = new float[width * height];
		for (int i = 0; i < pixels.length; i++)
			pixels[i] = random.nextInt(50) - 10;
		return pixels;
	}

	private static float at(final float[] pixels, final int width, final int x, final int y) {
		final int height = pixels.length / width;
		return pixels[Math.min(Math.max(y, 0), height - 1) * width
			+ Math.min(Math.max(x, 0), width - 1)];
	}

	@ParameterizedTest
	@CsvSource({"1,1", "2,3", "7,1", "1,6", "13,11", "40,9"})
	void hotPixelsAreHeldBetweenTheSecondOfTheirNeighbours(final int width, final int height) {
		final float[] in = drawn(width, height), out = HotPixels.clip(in, width);
		for (int y = 0; y < height; y++)
			for (int x = 0; x < width; x++) {
				final float[] around = new float[8];
				for (int k = 0, next = 0; k < 9; k++)
					if (k != 4)
						around[next++] = at(in, width, x + k % 3 - 1, y + k / 3 - 1);
				Arrays.sort(around);
				assertEquals(Math.max(around[1], Math.min(around[6], in[y * width + x])),
					out[y * width + x], "at " + x + ", " + y);
			}
	}

	@ParameterizedTest
	@CsvSource({"1,1,2", "5,3,1", "9,8,0", "12,10,3", "4,20,6"})
	void theLargestNearbyIsThatOfTheSquare(final int width, final int height, final int radius) {
		final float[] in = drawn(width, height), out = LocalMaximum.of(in, width, radius);
		for (int y = 0; y < height; y++)
			for (int x = 0; x < width; x++) {
				float most = Float.NEGATIVE_INFINITY;
				for (int v = y - radius; v <= y + radius; v++)
					for (int u = x - radius; u <= x + radius; u++)
						most = Math.max(most, at(in, width, u, v));
				assertEquals(most, out[y * width + x], "at " + x + ", " + y);
			}
	}

	@ParameterizedTest
	@CsvSource({"1,1,1", "6,4,3", "11,9,5", "8,3,9", "10,10,7"})
	void filtersAreSumsOfProducts(final int width, final int height, final int size) {
		final float[] in = drawn(width, height);
		final double[] kernel = new double[size];
		for (int k = 0; k < size; k++)
			kernel[k] = k - 1.5;
		final float[] rows = SeparableFilter.rows(in, width, kernel);
		final float[] columns = SeparableFilter.columns(in, width, kernel);
		for (int y = 0; y < height; y++)
			for (int x = 0; x < width; x++) {
				double alongRow = 0, alongColumn = 0;
				for (int k = 0; k < size; k++) {
					alongRow += kernel[k] * at(in, width, x + k - size / 2, y);
					alongColumn += kernel[k] * at(in, width, x, y + k - size / 2);
				}
				// Products of small halves and whole numbers: nothing is rounded.
				assertEquals(alongRow, rows[y * width + x], "at " + x + ", " + y);
				assertEquals(alongColumn, columns[y * width + x], "at " + x + ", " + y);
			}
	}

	@ParameterizedTest
	@CsvSource({"4,4,2", "7,5,2", "9,9,3", "6,2,1"})
	void blocksHaveTheirMean(final int width, final int height, final int factor) {
		final float[] in = drawn(width, height), out = Binning.mean(in, width, factor);
		final int columns = width / factor, rows = height / factor;
		final float[] means = new float[columns * rows];
		for (int i = 0; i < means.length; i++)
			for (int k = 0; k < factor * factor; k++)
				means[i] += in[(i / columns * factor + k / factor) * width + i % columns * factor
					+ k % factor] / (factor * factor);
		assertArrayEquals(means, out, 1e-5f);
	}
}
