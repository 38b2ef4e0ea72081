
package io.github.knotresolver.session;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import java.util.Random;

import net.imglib2.img.array.ArrayImgs;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import io.github.knotresolver.fit.NormalizedFrame;
import io.github.knotresolver.image.FrameEvidence;
import io.github.knotresolver.image.LineAppearance;
import io.github.knotresolver.model.Calibration;
import io.github.knotresolver.model.Movie;
import io.github.knotresolver.model.Polarity;
import io.github.knotresolver.skeleton.EvidenceFinder;
import io.github.knotresolver.track.FrameView;

/** Straight lines, 100 brighter than what is around them, as a camera with a ceiling shows them. */
class ClippingTest {

	private static final int SIZE = 160;

	private static Movie line(final double sigma, final double noise, final double ceiling) {
		final Random random = new Random(3);
		final float[] pixels = new float[SIZE * SIZE];
		for (int i = 0; i < pixels.length; i++) {
			final double d = i / SIZE - SIZE / 2;
			final double light = 100 * Math.exp(-d * d / (2 * sigma * sigma));
			pixels[i] = (float) Math.min(ceiling, light + noise * random.nextGaussian());
		}
		return new Movie("line", ArrayImgs.floats(pixels, SIZE, SIZE, 1), Calibration.NONE);
	}

	/** Noise takes a tenth of a wide line's pixels to a ceiling that is above the line. */
	@ParameterizedTest
	@CsvSource({"1.4, 8, 80, true", "1.4, 8, 150, false", "4.2, 60, 180, false",
		"4.2, 60, 60, true"})
	void aLineIsCutOffWhereItIsAndNotNoise(final double sigma, final double noise,
		final double ceiling, final boolean cut) {
		final Movie movie = line(sigma, noise, ceiling);
		final LineAppearance look = LineAppearance.of(Polarity.BRIGHT, sigma);
		final FrameEvidence evidence = new EvidenceFinder(look).find(movie.frame(0));
		final int size = SIZE / look.binning();
		final FrameView frame = new FrameView(1,
			NormalizedFrame.of(size, size, new float[size * size]), evidence);
		final WorkingPixels pixels = new WorkingPixels(look.binning(), 0, 0);
		assertEquals(cut, Clipping.along(movie, List.of(frame), pixels).isClipped());
	}
}
