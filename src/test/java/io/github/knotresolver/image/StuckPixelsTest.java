package io.github.knotresolver.image;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;
import java.util.stream.IntStream;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** A ring, a sharp bead and pixels that are too bright. */
class StuckPixelsTest {

	private static final int SIZE = 60;

	/** A ring of 100, sigma 1.4 px, around (30, 30); a bead of 600 at (10.3, 50.1). */
	private static double light(final int at, final double sharp) {
		final double x = at % SIZE, y = at / SIZE, off = Math.hypot(x - 30, y - 30) - 12;
		final double bead = Math.pow(x - 10.3, 2) + Math.pow(y - 50.1, 2);
		return 100 * Math.exp(-off * off / (2 * 1.96))
			+ 600 * Math.exp(-bead / (2 * sharp * sharp));
	}

	private static float[] picture(final double sharp, final int... hot) {
		final Random random = new Random(4);
		final float[] picture = new float[SIZE * SIZE];
		for (int at = 0; at < picture.length; at++)
			picture[at] = (float) (light(at, sharp) + random.nextGaussian());
		for (final int at : hot)
			picture[at] += 300;
		return picture;
	}

	@Test
	void pixelsThatStandAloneAreFoundOnARingToo() {
		final int[] hot = {5 * SIZE + 5, 30 * SIZE + 42, 29 * SIZE + 42, 0, SIZE * SIZE - 30};
		final StuckPixels found = StuckPixels.in(picture(1.4, hot), SIZE, 50);
		assertEquals(hot.length, found.count());
		for (final int at : hot)
			assertTrue(found.contains(at), at + "");
	}

	/** As sharp as a lens draws it. */
	@ParameterizedTest
	@ValueSource(doubles = {0.8, 1, 2})
	void noBeadAndNoRingIsOne(final double sharp) {
		assertEquals(0, StuckPixels.in(picture(sharp), SIZE, 50).count());
	}

	@Test
	void oneIsFilledWithTheLineThatRunsThrough() {
		final int[] ring = IntStream.range(0, SIZE * SIZE)
			.filter(at -> light(at, 1.4) > 90 && at % SIZE > 15).toArray();
		assertFalse(ring.length == 0);
		for (final int at : ring) {
			final float[] picture = picture(1.4, at);
			final StuckPixels found = StuckPixels.in(picture, SIZE, 50);
			assertTrue(found.contains(at));
			assertEquals(light(at, 1.4), found.filled(at, i -> picture[i]), 8);
		}
	}
}
