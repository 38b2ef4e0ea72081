package io.github.knotresolver.skeleton;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Random;
import java.util.function.DoubleUnaryOperator;
import java.util.stream.IntStream;

import net.imglib2.img.Img;
import net.imglib2.img.array.ArrayImgs;
import net.imglib2.type.logic.BitType;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import io.github.knotresolver.image.FrameEvidence;
import io.github.knotresolver.image.LineAppearance;
import io.github.knotresolver.image.Pixels;
import io.github.knotresolver.mask.ChanVese;
import io.github.knotresolver.model.Calibration;
import io.github.knotresolver.model.Movie;
import io.github.knotresolver.model.Polarity;
import io.github.knotresolver.progress.Progress;
import io.github.knotresolver.progress.Workers;

/** Lines that are drawn and noise that is known. */
class EvidenceFinderTest {

	private static final int SIZE = 120, FRAMES = 4;

	/** A sine wave of 80 px that moves, in frames with noise of standard deviation 4. */
	private static float[] wave(final double sigma, final double height, final double distance) {
		final Random random = new Random(5);
		final float[] pixels = new float[FRAMES * SIZE * SIZE];
		for (int i = 0; i < pixels.length; i++) {
			final int t = i / (SIZE * SIZE), x = i % SIZE, y = i / SIZE % SIZE;
			double light = 0;
			for (final double side : new double[]{-0.5, 0.5})
				light = Math.max(light, height * strand(x, y - side * distance, t, sigma));
			pixels[i] = (float) (100 + light + 4 * random.nextGaussian());
		}
		return pixels;
	}

	private static double strand(final double x, final double y, final int t, final double sigma) {
		final double d = (y - 60 - 12 * Math.sin((x + 5 * t) / 18))
			* Math.cos(Math.atan(12 / 18.0 * Math.cos((x + 5 * t) / 18)));
		final double out = Math.max(0, Math.max(20 - x, x - 100));
		return Math.exp(-(d * d + out * out) / (2 * sigma * sigma));
	}

	private static Movie movie(final float[] pixels) {
		return new Movie("drawn", ArrayImgs.floats(pixels, SIZE, SIZE, FRAMES), Calibration.NONE);
	}

	private static float[] changed(final float[] pixels, final DoubleUnaryOperator change) {
		final float[] changed = new float[pixels.length];
		for (int i = 0; i < changed.length; i++)
			changed[i] = (float) change.applyAsDouble(pixels[i]);
		return changed;
	}

	private static AppearanceFinder.Found look(final Movie movie, final Polarity polarity) {
		return new AppearanceFinder(Workers.HERE, Progress.NONE).find(movie,
			IntStream.rangeClosed(1, FRAMES).boxed().toList(), polarity);
	}

	private static FrameEvidence first(final Movie movie) {
		return new EvidenceFinder(look(movie, Polarity.AUTO).appearance()).find(movie.frame(0));
	}

	@ParameterizedTest
	@ValueSource(doubles = {1.0, 1.4, 2.2, 4, 7})
	void widthAndPolarityAreFound(final double sigma) {
		for (final int sign : new int[]{1, -1}) {
			final AppearanceFinder.Found found = look(
				movie(changed(wave(sigma, 100, 0), v -> sign * v)), Polarity.AUTO);
			final LineAppearance a = found.appearance();
			assertEquals(sign == 1 ? Polarity.BRIGHT : Polarity.DARK, a.polarity());
			assertFalse(found.doubtful());
			assertEquals(sigma, a.sigma(), 0.15 * sigma);
			assertTrue(a.workingSigma() < 2.2, a.toString());
			assertTrue(sigma < 1.5 || a.workingSigma() > 1, a.toString());
		}
	}

	/** Every other frame is sharp: these are not binned as far as the usual width would have it. */
	@Test
	void whereFocusWandersSharpFramesAreNotBinned() {
		final float[] sharp = wave(1.8, 100, 0), mixed = wave(3.2, 100, 0);
		for (int i = 0; i < mixed.length; i++)
			if (i / (SIZE * SIZE) % 2 == 0)
				mixed[i] = sharp[i];
		final LineAppearance usual = look(movie(wave(2.3, 100, 0)), Polarity.BRIGHT).appearance();
		assertEquals(2, usual.binning());
		final LineAppearance wandering = look(movie(mixed), Polarity.BRIGHT).appearance();
		assertEquals(2.4, wandering.sigma(), 0.25);
		assertEquals(1, wandering.binning());
	}

	/** Cut off at half of its height a line looks wider. */
	@Test
	void aLineThatWasCutOffIsNotBinnedAsIfItWereAsWideAsItLooks() {
		final float[] whole = wave(2.3, 100, 0),
			cut = changed(wave(1.7, 100, 0), v -> Math.min(140, v));
		assertEquals(2, look(movie(whole), Polarity.BRIGHT).appearance().binning());
		final LineAppearance wide = look(movie(cut), Polarity.BRIGHT).appearance();
		assertTrue(wide.sigma() > 1.5 * 1.4, wide.toString());
		assertEquals(1, wide.binning());
		assertEquals(1, look(movie(changed(cut, v -> -v)), Polarity.DARK).appearance().binning());
	}

	/** Where light does not add up a line is as bright as its middle almost to its sides. */
	@Test
	void aBluntLineIsNotBinnedAsIfItWereAsWideAsItLooks() {
		final float[] blunt = changed(wave(1.8, 100, 0),
			v -> 100 + 100 * (1 - Math.pow(1 - Math.min(1, (v - 100) / 100), 2.5)));
		final LineAppearance a = look(movie(blunt), Polarity.BRIGHT).appearance();
		assertTrue(a.sigma() > 1.5 * 1.4, a.toString());
		assertEquals(1, a.binning());
	}

	@Test
	void theLineIsFollowedFromEndToEndAndNothingElse() {
		final FrameEvidence e = first(movie(wave(1.4, 60, 0)));
		int left = SIZE, right = 0;
		for (int i = 0; i < e.size(); i++) {
			assertTrue(strand(e.x(i), e.y(i), 0, 2.5) > 0.5, e.x(i) + "," + e.y(i));
			left = Math.min(left, e.x(i));
			right = Math.max(right, e.x(i));
			assertEquals(1.4 * 2.355, e.lineWidth(e.x(i), e.y(i)), 1.7);
			assertTrue(e.z(e.x(i), e.y(i)) > 2);
		}
		assertEquals(20, left, 3);
		assertEquals(100, right, 3);
		assertTrue(e.surety() > 50, "surety " + e.surety());
	}

	@Test
	void gradientBrightnessAndInversionChangeNothing() {
		final float[] pixels = wave(1.4, 60, 0);
		final boolean[] plain = Pixels.bits(first(movie(pixels)).mask());
		assertSame(plain, changed(pixels, v -> 7 * v + 1000));
		assertSame(plain, changed(pixels, v -> 500 - v));
		final float[] slope = pixels.clone();
		for (int i = 0; i < slope.length; i++)
			slope[i] += 2 * (i % SIZE) - 0.7f * (i / SIZE % SIZE);
		assertSame(plain, slope);
	}

	/** Up to what rounding does to a pixel here and there. */
	private static void assertSame(final boolean[] plain, final float[] pixels) {
		final boolean[] mask = Pixels.bits(first(movie(pixels)).mask());
		int off = 0;
		for (int i = 0; i < mask.length; i++)
			off += mask[i] == plain[i] ? 0 : 1;
		assertTrue(off <= 6, off + " pixels differ");
	}

	@Test
	void strandsSideBySideStayApart() {
		final FrameEvidence e = first(movie(wave(1.4, 100, 6)));
		int apart = 0, columns = 0;
		for (int x = 30; x < 90; x++) {
			int strands = 0;
			for (int y = 0; y < SIZE; y++)
				strands += e.skeleton().getAt(x, y).get() ? 1 : 0;
			columns++;
			apart += strands >= 2 ? 1 : 0;
		}
		assertTrue(apart > 0.9 * columns, apart + " of " + columns);
	}

	@ParameterizedTest
	@ValueSource(longs = {1, 2, 3})
	void inNoiseThereIsNothing(final long seed) {
		final Random random = new Random(seed);
		final float[] pixels = new float[FRAMES * SIZE * SIZE];
		for (int i = 0; i < pixels.length; i++)
			pixels[i] = (float) (50 + 5 * random.nextGaussian());
		final FrameEvidence e = first(movie(pixels));
		assertTrue(e.surety() < 8, "surety " + e.surety() + " with seed " + seed);
		assertTrue(e.size() < 60, e.size() + " pixels with seed " + seed);
	}

	/** The reason why masks by evidence are not refined. */
	@Test
	void aDimEndIsFollowedAndAnActiveContourWouldLoseIt() {
		final float[] pixels = wave(1.4, 100, 0);
		final Random random = new Random(8);
		for (int i = 0; i < pixels.length; i++) {
			final double share = 1 - 0.8 * Math.min(80, Math.max(0, i % SIZE - 20)) / 80;
			pixels[i] = (float) (100 + share * (pixels[i] - 100) + 4 * random.nextGaussian());
		}
		final FrameEvidence e = first(movie(pixels));
		final float[] light = new float[SIZE * SIZE];
		for (int i = 0; i < light.length; i++)
			light[i] = pixels[i] - 100;
		final Img<BitType> refined = Skeletonize
			.thin(ChanVese.evolve(Pixels.image(light, SIZE), e.mask(), 10, 0.4, 0.2));
		assertEquals(100, rightmost(e.skeleton()), 6);
		assertTrue(rightmost(refined) < 92, "active contour to " + rightmost(refined));
	}

	private static int rightmost(final Img<BitType> line) {
		int right = 0;
		final boolean[] bits = Pixels.bits(line);
		for (int at = 0; at < bits.length; at++)
			if (bits[at])
				right = Math.max(right, at % SIZE);
		return right;
	}

	@Test
	void aPartKeepsWhatIsKnown() {
		final FrameEvidence e = first(movie(wave(1.4, 60, 0)));
		final FrameEvidence part = e.part(10, 20, 50, 60);
		assertTrue(part.size() > 20);
		for (int i = 0; i < part.size(); i++) {
			final int x = part.x(i), y = part.y(i);
			assertEquals(e.z(x + 10, y + 20), part.z(x, y));
			assertEquals(e.angle(x + 10, y + 20), part.angle(x, y));
			assertEquals(e.lineWidth(x + 10, y + 20), part.lineWidth(x, y));
			assertTrue(part.skeleton().getAt(x, y).get() && part.mask().getAt(x, y).get());
		}
		assertTrue(Double.isNaN(part.angle(0, 0)) && Double.isNaN(part.lineWidth(0, 0)));
	}

	@Test
	void aConstantMovieHasNoLines() {
		final FrameEvidence e = first(movie(new float[FRAMES * SIZE * SIZE]));
		assertEquals(List.of(0, 0.0), List.of(e.size(), e.surety()));
	}
}
