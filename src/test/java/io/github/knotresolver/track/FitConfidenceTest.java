package io.github.knotresolver.track;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import java.util.Random;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import io.github.knotresolver.Drawn;
import io.github.knotresolver.fit.Chain;
import io.github.knotresolver.fit.Fit;
import io.github.knotresolver.fit.FitQuality;

class FitConfidenceTest {

	private static final FitConfidence CONFIDENCE = new FitConfidence(2);

	private static final FitQuality USUAL = new FitQuality(2, 0);

	@Test
	void withoutAGapNothingIsSureAndAWideGapIs() {
		assertEquals(0, CONFIDENCE.of(0, USUAL, 0), 1e-9);
		final double[] gaps = {0, 0.2, 1, 3, 8, 30};
		for (int i = 1; i < gaps.length; i++)
			assertTrue(
				CONFIDENCE.of(gaps[i], USUAL, 0) > CONFIDENCE.of(gaps[i - 1], USUAL, 0) + 1e-6,
				"gap " + gaps[i]);
		assertTrue(CONFIDENCE.of(30, USUAL, 0) > 0.95);
		assertEquals(1, CONFIDENCE.of(Double.POSITIVE_INFINITY, USUAL, 0), 1e-9);
	}

	@Test
	void aContourThatDoesNotExplainItsFrameIsNotTrusted() {
		assertEquals(CONFIDENCE.of(9, new FitQuality(0.5, 0), 0), CONFIDENCE.of(9, USUAL, 0), 0.2);
		assertTrue(CONFIDENCE.of(9, new FitQuality(4, 0), 0) < 0.8 * CONFIDENCE.of(9, USUAL, 0));
		assertTrue(CONFIDENCE.of(9, new FitQuality(20, 0), 0) < 0.05);
	}

	@Test
	void darknessAndWhatItDoesNotRunAlongSpeakAgainstIt() {
		assertTrue(CONFIDENCE.of(9, new FitQuality(2, 0.5), 0) < 0.7 * CONFIDENCE.of(9, USUAL, 0));
		assertTrue(CONFIDENCE.of(9, new FitQuality(2, 1), 0) < 0.05);
		assertTrue(CONFIDENCE.of(9, USUAL, 0.7) < 0.7 * CONFIDENCE.of(9, USUAL, 0));
		assertTrue(CONFIDENCE.of(9, USUAL, 1.5) < 0.05);
	}

	@ParameterizedTest
	@ValueSource(longs = {1, 2, 3, 4, 5, 6, 7, 8})
	void isAShareThatNothingWorseRaises(final long seed) {
		final Random random = new Random(seed);
		for (int i = 0; i < 200; i++) {
			final double gap = 10 * random.nextDouble(), misfit = 8 * random.nextDouble(),
				dark = random.nextDouble(), uncovered = 2 * random.nextDouble();
			final double c = CONFIDENCE.of(gap, new FitQuality(misfit, dark), uncovered);
			final String at = "seed " + seed + ", trial " + i;
			assertTrue(c >= 0 && c <= 1, at);
			assertTrue(CONFIDENCE.of(gap / 2, new FitQuality(misfit, dark), uncovered) <= c, at);
			assertTrue(CONFIDENCE.of(gap, new FitQuality(2 * misfit, dark), uncovered) <= c, at);
			assertTrue(CONFIDENCE.of(gap, new FitQuality(misfit, (1 + dark) / 2), uncovered) <= c,
				at);
			assertTrue(CONFIDENCE.of(gap, new FitQuality(misfit, dark), uncovered + 0.2) <= c, at);
		}
	}

	@Test
	void whatIsUsualIsTheMedianOfTheMovie() {
		final List<Optional<FitQuality>> movie = List.of(quality(9), quality(1), Optional.empty(),
			quality(3), quality(2), quality(100));
		assertEquals(3, FitConfidence.learn(movie).usualMisfit());
		final double none = FitConfidence.learn(List.of(Optional.empty())).of(3, USUAL, 0);
		assertTrue(none >= 0 && none <= 1);
	}

	@Test
	void theGapIsThatToAContourThatLooksDifferent() {
		final List<Fit> pool = List.of(line(0), line(1), line(20), line(-30));
		final TrellisPath path = new TrellisPath(new int[]{0}, new double[][]{{5, 5.5, 12, 9}}, 5);
		assertEquals(4, FitConfidence.gap(path, pool, 0), 1e-9);
		assertEquals(Double.POSITIVE_INFINITY, FitConfidence.gap(
			new TrellisPath(new int[]{0}, new double[][]{{5, 5.5}}, 5), pool.subList(0, 2), 0));
	}

	private static Fit line(final double y) {
		return new Fit(Chain.along(Drawn.line(0, y, 50, y), 10, 50), 0, 0, 1);
	}

	private static Optional<FitQuality> quality(final double misfit) {
		return Optional.of(new FitQuality(misfit, 0));
	}
}
