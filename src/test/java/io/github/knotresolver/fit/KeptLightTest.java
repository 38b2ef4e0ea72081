package io.github.knotresolver.fit;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.Random;
import java.util.function.Supplier;

import org.junit.jupiter.api.Test;

/** However a frame is kept, its values are the same, bit by bit. */
class KeptLightTest {

	private static final int WIDTH = 23, HEIGHT = 17;

	@Test
	void keepingLessChangesNothing() {
		final float[] light = new float[WIDTH * HEIGHT];
		final double[] wide = new double[light.length];
		final Random random = new Random(3);
		for (int i = 0; i < light.length; i++)
			wide[i] = light[i] = (float) random.nextGaussian();
		final NormalizedFrame asIs = new NormalizedFrame(WIDTH, HEIGHT, wide);
		final Supplier<float[]> again = light::clone;
		for (final NormalizedFrame frame : new NormalizedFrame[]{
			NormalizedFrame.of(WIDTH, HEIGHT, light), NormalizedFrame.of(WIDTH, HEIGHT, again)}) {
			assertSame(asIs, frame);
			assertSame(asIs.rescaled(0.3, 7), frame.rescaled(0.3, 7));
			assertSame(asIs.rescaled(0.3, 7).rescaled(-0.1, 1.7),
				frame.rescaled(0.3, 7).rescaled(-0.1, 1.7));
			assertSame(asIs.rescaled(0.3, 7).blurred(1).rescaled(0, 3),
				frame.rescaled(0.3, 7).blurred(1).rescaled(0, 3));
			assertSame(asIs.window(3, 4, 5, 6), frame.window(3, 4, 5, 6));
		}
	}

	@Test
	void sizeMustFit() {
		assertThrows(IllegalArgumentException.class,
			() -> NormalizedFrame.of(WIDTH, HEIGHT, new float[5]));
	}

	private static void assertSame(final NormalizedFrame expected, final NormalizedFrame frame) {
		assertArrayEquals(expected.pixels(), frame.pixels(), 0);
	}
}
