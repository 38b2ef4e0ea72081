
package io.github.knotresolver.mask;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Random;

import org.junit.jupiter.api.Test;

import io.github.knotresolver.image.Pixels;

class OtsuThresholdTest {

	@Test
	void twoLevelsArePartedInTheMiddle() {
		assertEquals(0.5, OtsuThreshold.of(Pixels.image(new float[]{0.2f, 0.8f, 0.2f, 0.2f}, 2)),
			0.003);
	}

	@Test
	void nothingIsAboveTheThresholdOfAConstantFrame() {
		assertEquals(1, OtsuThreshold.of(Pixels.image(new float[6], 3)));
	}

	@Test
	void agreesWithTryingEveryThreshold() {
		for (int seed = 0; seed < 20; seed++) {
			final Random random = new Random(seed);
			final float[] values = new float[400];
			for (int i = 0; i < values.length; i++)
				values[i] = Math
					.round(255 * Math.min(1,
						Math.max(0, (i % 4 == 0 ? 0.7 : 0.3) + 0.1 * random.nextGaussian())))
					/ 255f;
			final double threshold = OtsuThreshold.of(Pixels.image(values, 20));
			double best = 0;
			for (int bin = 0; bin < 255; bin++)
				best = Math.max(best, betweenClasses(values, (bin + 0.5) / 255));
			assertEquals(best, betweenClasses(values, threshold), 1e-9, "seed " + seed);
		}
	}

	private static double betweenClasses(final float[] values, final double threshold) {
		double dark = 0, bright = 0;
		int n = 0;
		for (final float value : values) {
			if (value > threshold)
				bright += value;
			else {
				dark += value;
				n++;
			}
		}
		final int m = values.length - n;
		return n == 0 || m == 0 ? 0 : (double) n * m * Math.pow(dark / n - bright / m, 2);
	}
}
