package io.github.knotresolver.session;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Random;
import java.util.stream.IntStream;

import net.imglib2.img.array.ArrayImgs;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import io.github.knotresolver.image.Pixels;
import io.github.knotresolver.model.Calibration;
import io.github.knotresolver.model.Movie;
import io.github.knotresolver.model.Polarity;
import io.github.knotresolver.progress.Progress;
import io.github.knotresolver.progress.Workers;
import io.github.knotresolver.skeleton.AppearanceFinder;

/** A sine wave that moves, and beads that do not, one of them saturated and on its track. */
class StillSpotsTest {

	private static final int SIZE = 100, LIMIT = 900;

	private static final double SIGMA = 1.4, STRAND = 100, NOISE = 4;

	private static final double[][] BEADS = {{20, 20, 150}, {80, 30, 160}, {60, 85, 150},
		{50, 50, 2000}};

	private static Movie movie(final int frames, final double[][] beads, final int sign) {
		final Random random = new Random(8);
		final float[] pixels = new float[frames * SIZE * SIZE];
		for (int i = 0; i < pixels.length; i++) {
			final int t = i / (SIZE * SIZE), x = i % SIZE, y = i / SIZE % SIZE;
			double light = line(t, x, y);
			for (final double[] b : beads)
				light += b[2] * Math.exp(-((x - b[0]) * (x - b[0]) + (y - b[1]) * (y - b[1]))
					/ (2 * 1.69 * SIGMA * SIGMA));
			pixels[i] = (float) (1000
				+ sign * Math.min(LIMIT, light + NOISE * random.nextGaussian()));
		}
		return new Movie("drawn", ArrayImgs.floats(pixels, SIZE, SIZE, frames), Calibration.NONE);
	}

	private static double line(final int t, final double x, final double y) {
		final double slope = 0.9 * Math.cos((x + 6 * t) / 16);
		final double d = (y - 50 - 14.4 * Math.sin((x + 6 * t) / 16)) / Math.hypot(1, slope);
		final double out = Math.max(0, Math.max(12 - x, x - 88));
		return STRAND * Math.exp(-(d * d + out * out) / (2 * SIGMA * SIGMA));
	}

	private static StillSpots of(final Movie movie) {
		final List<Integer> frames = IntStream.rangeClosed(1, movie.size()).boxed().toList();
		final AppearanceFinder finder = new AppearanceFinder(Workers.HERE, Progress.NONE);
		return StillSpots.off(movie, frames, finder.find(movie, frames, Polarity.AUTO),
			m -> finder.find(m, frames, Polarity.AUTO));
	}

	@ParameterizedTest
	@ValueSource(ints = {1, -1})
	void beadsAreTakenOffAndTheFilamentStays(final int sign) {
		final StillSpots spots = of(movie(24, BEADS, sign));
		assertEquals(BEADS.length, spots.count());
		assertEquals(SIGMA, spots.lines().appearance().sigma(), 0.15);
		for (int t = 0; t < 24; t++) {
			final float[] frame = Pixels.floats(spots.movie().frame(t));
			double squares = 0;
			for (int i = 0; i < frame.length; i++)
				squares += Math.pow(sign * (frame[i] - 1000) - line(t, i % SIZE, i / SIZE), 2)
					/ frame.length;
			assertTrue(Math.sqrt(squares) < 2 * NOISE, t + ": " + Math.sqrt(squares));
		}
	}

	@Test
	void aLineGoesOnWhereABeadDazzles() {
		final StillSpots spots = of(movie(24, BEADS, 1));
		int through = 0;
		for (int t = 0; t < 24; t++)
			if (line(t, 50, 50) > 0.8 * STRAND) {
				through++;
				assertTrue(
					Pixels.floats(spots.movie().frame(t))[50 * SIZE + 50] - 1000 > 0.5 * STRAND,
					"frame " + t);
			}
		assertTrue(through > 0);
	}

	/** Two of them beside each other, one where the filament passes. */
	@ParameterizedTest
	@ValueSource(ints = {3, 24})
	void hotPixelsAreFilledInFromAroundThem(final int frames) {
		final Movie plain = movie(frames, new double[0][], 1);
		final float[] pixels = Pixels.floats(plain.frame(0));
		final int[] hot = {10 * SIZE + 10, 10 * SIZE + 11, 52 * SIZE + 40, 99};
		final float[] all = new float[frames * SIZE * SIZE];
		for (int t = 0; t < frames; t++) {
			System.arraycopy(Pixels.floats(plain.frame(t)), 0, all, t * SIZE * SIZE, pixels.length);
			for (final int at : hot)
				all[t * SIZE * SIZE + at] += 400;
		}
		final StillSpots still = of(
			new Movie("hot", ArrayImgs.floats(all, SIZE, SIZE, frames), Calibration.NONE));
		assertEquals(hot.length, still.hot());
		assertEquals(0, still.count());
		for (int t = 0; t < frames; t++) {
			final float[] frame = Pixels.floats(still.movie().frame(t));
			for (final int at : hot)
				assertEquals(1000 + line(t, at % SIZE, at / SIZE), frame[at], 5 * NOISE,
					"frame " + t + ", pixel " + at);
		}
	}

	@Test
	void aMovieWithoutSpotsIsLeftAsItIs() {
		final Movie movie = movie(24, new double[0][], 1);
		assertSame(movie, of(movie).movie());
	}

	@Test
	void aFewFramesDoNotTellWhatStays() {
		final Movie movie = movie(6, BEADS, 1);
		final StillSpots spots = of(movie);
		assertSame(movie, spots.movie());
		assertEquals(0, spots.count());
	}
}
