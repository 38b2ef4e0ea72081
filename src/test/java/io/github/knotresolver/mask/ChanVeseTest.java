
package io.github.knotresolver.mask;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;

import net.imglib2.img.Img;
import net.imglib2.type.logic.BitType;
import net.imglib2.type.numeric.real.FloatType;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import io.github.knotresolver.Ascii;
import io.github.knotresolver.image.Pixels;
import io.github.knotresolver.mask.ConnectedComponents.MaskObject;
import io.github.knotresolver.model.Segmentation;

class ChanVeseTest {

	private static final int SIZE = 61;

	/** A line of 40 px with a Gaussian profile, 5 px wide at half maximum. */
	private static Img<FloatType> filament() {
		final float[] values = new float[SIZE * SIZE];
		for (int i = 0; i < values.length; i++) {
			final double beyond = Math.max(0, Math.abs(i % SIZE - 30) - 20);
			final double distance = Math.hypot(beyond, i / SIZE - 30);
			values[i] = (float) Math.exp(-distance * distance / 9);
		}
		return Pixels.image(values, SIZE);
	}

	@ParameterizedTest
	@ValueSource(doubles = {0.2, 0.5, 0.8})
	void frontRestsAtTheLevelOfTheBias(final double start) {
		final Img<FloatType> frame = filament();
		final float[] values = Pixels.floats(frame);
		final boolean[] mask = Pixels
			.bits(ChanVese.evolve(frame, FixedThreshold.above(frame, start), 60, 0.4, 0));
		double in = 0, out = 0;
		int n = 0;
		for (int i = 0; i < mask.length; i++) {
			if (mask[i])
				n++;
			if (mask[i])
				in += values[i];
			else
				out += values[i];
		}
		final double level = out / (mask.length - n) + 0.7 * (in / n - out / (mask.length - n));
		for (int i = 0; i < mask.length; i++)
			if (Math.abs(values[i] - level) > 0.12)
				assertEquals(values[i] > level, mask[i],
					"x " + i % SIZE + " y " + i / SIZE + " value " + values[i]);
	}

	@Test
	void defaultsKeepTheLengthOfAFilament() {
		final Img<FloatType> frame = filament();
		final MaskObject object = ConnectedComponents
			.of(new FilamentSegmenter(Segmentation.DEFAULT).segment(frame)).objects().get(0);
		final int length = object.maxX() - object.minX() + 1;
		assertTrue(length >= 41 && length <= 45, "length " + length);
		assertTrue(object.maxY() - object.minY() >= 2, "width");
	}

	@Test
	void oneIterationMovesTheFrontByOnePixelAtMost() {
		final Img<FloatType> frame = filament();
		final boolean[] seed = Pixels.bits(FixedThreshold.above(frame, 0.1));
		final boolean[] after = Pixels
			.bits(ChanVese.evolve(frame, Pixels.mask(seed, SIZE), 1, 1, 0));
		for (int i = 0; i < seed.length; i++)
			if (seed[i] && seed[i - 1] && seed[i + 1] && seed[i - SIZE] && seed[i + SIZE])
				assertTrue(after[i], "pixel " + i);
	}

	@Test
	void biasShrinksAndItsOppositeGrows() {
		final Img<FloatType> frame = filament();
		final Img<BitType> seed = FixedThreshold.above(frame, 0.5);
		final int none = count(ChanVese.evolve(frame, seed, 10, 0, 0));
		assertTrue(count(ChanVese.evolve(frame, seed, 10, 0.8, 0)) < none);
		assertTrue(count(ChanVese.evolve(frame, seed, 10, -0.8, 0)) > none);
	}

	@Test
	void smoothingTakesABumpAway() {
		final Img<BitType> seed = Ascii.mask("""
			............
			.....#......
			.....#......
			.....#......
			.##########.
			.##########.
			.##########.
			.##########.
			............
			""");
		final float[] values = new float[12 * 9];
		final boolean[] bits = Pixels.bits(seed);
		for (int i = 0; i < bits.length; i++)
			values[i] = bits[i] ? 0.6f : 0.4f;
		final Img<FloatType> frame = Pixels.image(values, 12);
		assertTrue(ChanVese.evolve(frame, seed, 20, 0, 0).getAt(5, 1).get());
		assertTrue(!ChanVese.evolve(frame, seed, 20, 0, 3).getAt(5, 1).get());
	}

	@Test
	void vanishedMaskIsEmpty() {
		final float[] values = new float[100];
		values[44] = values[45] = 0.3f;
		values[99] = 1;
		final Img<FloatType> frame = Pixels.image(values, 10);
		final boolean[] seed = new boolean[100];
		seed[44] = seed[45] = seed[46] = seed[54] = true;
		assertEquals(0, count(ChanVese.evolve(frame, Pixels.mask(seed, 10), 50, 1, 1)));
		assertEquals(0,
			count(ChanVese.evolve(frame, Pixels.mask(new boolean[100], 10), 10, 0.4, 0.2)));
	}

	@Test
	void objectsAtTheBorderAndFullFramesDoNotCrash() {
		final float[] values = new float[20 * 10];
		for (int i = 0; i < values.length; i++)
			values[i] = i / 20 < 4 ? 1 : 0;
		final Img<FloatType> frame = Pixels.image(values, 20);
		final Img<BitType> mask = ChanVese.evolve(frame, FixedThreshold.above(frame, 0.5), 10, 0.4,
			0.2);
		assertEquals(80, count(mask));
		final boolean[] all = new boolean[200];
		Arrays.fill(all, true);
		assertEquals(200, count(ChanVese.evolve(frame, Pixels.mask(all, 20), 10, 0.4, 0.2)));
	}

	@Test
	void sameInputSameBytes() {
		final Img<FloatType> frame = filament();
		final Img<BitType> seed = FixedThreshold.above(frame, 0.3);
		assertArrayEquals(Pixels.bits(ChanVese.evolve(frame, seed, 10, 0.4, 0.2)),
			Pixels.bits(ChanVese.evolve(frame, seed, 10, 0.4, 0.2)));
	}

	@Test
	void seedOfAnotherSizeIsRefused() {
		assertTrue(assertThrows(IllegalArgumentException.class,
			() -> ChanVese.evolve(filament(), Ascii.mask("..."), 10, 0.4, 0.2)).getMessage()
			.contains("3 x 1"));
	}

	private static int count(final Img<BitType> mask) {
		int count = 0;
		for (final boolean bit : Pixels.bits(mask))
			if (bit)
				count++;
		return count;
	}
}
