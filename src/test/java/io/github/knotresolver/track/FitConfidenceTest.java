package io.github.knotresolver.track;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
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

	private static final int FIGURES = FitEvidence.NAMES.split(",").length;
	private static final int FAINT = List.of(FitEvidence.NAMES.split(",")).indexOf("faint");

	private static FitEvidence evidence(final double... f) {
		return new FitEvidence(f[0], f[1], f[2], f[3], f[4], f[5], f[6], f[7], f[8], f[9], f[10],
			f[11], f[12], f[13]);
	}

	private static double confidence(final double... figures) {
		return FitConfidence.of(evidence(figures));
	}

	@Test
	void whatNothingSpeaksAgainstIsSureAndNeedsNoReason() {
		final double[] none = new double[FIGURES];
		assertTrue(confidence(none) > 0.95, confidence(none) + "");
		assertEquals("", FitConfidence.reason(evidence(none)));
	}

	@Test
	void inStrongNoiseDoubtCountsForMore() {
		final double[] figures = new double[FIGURES];
		figures[FAINT] = FitEvidence.faint(0.35);
		figures[0] = 1;
		final double clear = confidence(figures);
		figures[FAINT] = FitEvidence.faint(0.7);
		assertTrue(clear > 0.95 && confidence(figures) < 0.9, clear + ", " + confidence(figures));
	}

	@Test
	void aDoubtTakesTheConfidenceButRefusesNothing() {
		for (int k = FitEvidence.DOUBTS; k < FIGURES; k++) {
			final double[] figures = new double[FIGURES];
			figures[k] = 1;
			final double doubted = confidence(figures);
			assertTrue(doubted > 0.5 && doubted < 0.9, doubted + "");
			figures[0] = 1;
			figures[2] = 1;
			final double doubtedOnce = confidence(figures);
			figures[k] = 0;
			assertTrue(confidence(figures) < 0.5);
			assertEquals(confidence(figures), doubtedOnce, 1e-12);
		}
	}

	@Test
	void aPatternThatIsPlainIsADoubtWhereOthersHaveNone() {
		assertEquals(0, FitEvidence.worse(0.6, 0.1), 1e-12);
		assertEquals(0, FitEvidence.worse(0.9, 0.85), 1e-12);
		assertTrue(FitEvidence.worse(0.9, 0.6) > 1);
		final double[] figures = new double[FIGURES];
		figures[2] = 0.9;
		final double before = confidence(figures);
		figures[FIGURES - 1] = FitEvidence.worse(0.9, 0.6);
		assertTrue(before > 0.9, before + "");
		assertEquals(0.5, confidence(figures), 1e-12);
	}

	@Test
	void whatEverythingSpeaksAgainstIsNotResolved() {
		final double[] all = new double[FIGURES];
		Arrays.fill(all, Double.POSITIVE_INFINITY);
		assertTrue(confidence(all) < TrackTuning.NO_CONFIDENCE);
		Arrays.fill(all, Double.NaN);
		assertTrue(confidence(all) < TrackTuning.NO_CONFIDENCE);
	}

	@ParameterizedTest
	@ValueSource(longs = {1, 2, 3, 4, 5, 6, 7, 8})
	void isAShareThatNothingWorseRaises(final long seed) {
		final Random random = new Random(seed);
		for (int i = 0; i < 200; i++) {
			final double[] figures = random.doubles(FIGURES, 0, 0.4).toArray();
			final double before = confidence(figures);
			assertTrue(before >= 0 && before <= 1);
			for (int k = 0; k < FIGURES; k++) {
				final double[] worse = figures.clone();
				worse[k] += random.nextDouble();
				assertTrue(confidence(worse) <= before,
					"seed " + seed + ", trial " + i + ", figure " + k);
			}
		}
	}

	@Test
	void aReasonNamesWhatSpeaksAgainstAContour() {
		final double[] figures = new double[FIGURES];
		figures[0] = 1;
		figures[4] = 0.5;
		figures[6] = 1;
		final String reason = FitConfidence.reason(evidence(figures));
		assertTrue(confidence(figures) < 0.9);
		assertTrue(reason.startsWith("Doubtful: ") && reason.endsWith("."), reason);
		assertTrue(reason.contains(FitEvidence.words(4)) || reason.contains(FitEvidence.words(0))
			|| reason.contains(FitEvidence.words(6)), reason);
	}

	@Test
	void aWideGapIsNoRivalAndAUsualMisfitNone() {
		assertEquals(1, FitConfidence.rival(0), 1e-9);
		assertEquals(0, FitConfidence.rival(Double.POSITIVE_INFINITY), 1e-9);
		assertTrue(FitConfidence.rival(1) > FitConfidence.rival(3));
		final FitConfidence confidence = new FitConfidence(2);
		assertEquals(0, confidence.misfit(new FitQuality(1.5, 0)), 1e-9);
		assertEquals(Math.log(3), confidence.misfit(new FitQuality(6, 0)), 1e-9);
	}

	@Test
	void whatIsUsualIsTheMedianOfTheMovie() {
		final List<Optional<FitQuality>> movie = List.of(quality(9), quality(1), Optional.empty(),
			quality(3), quality(2), quality(100));
		assertEquals(3, FitConfidence.learn(movie).usualMisfit());
		assertTrue(FitConfidence.learn(List.of(Optional.empty())).usualMisfit() > 0);
	}

	@Test
	void theGapIsThatToAContourThatLooksDifferent() {
		final List<Fit> pool = List.of(line(0), line(1), line(20), line(-30));
		final TrellisPath path = new TrellisPath(new int[]{0}, new double[][]{{5, 5.5, 12, 9}}, 5);
		assertEquals(4, FitConfidence.gap(path, pool, 0), 1e-9);
		assertEquals(Double.POSITIVE_INFINITY, FitConfidence.gap(
			new TrellisPath(new int[]{0}, new double[][]{{5, 5.5}}, 5), pool.subList(0, 2), 0));
	}

	@Test
	void ofTwoThatCostTheSameNoneIsSurerThanOneHalf() {
		final Fit straight = new Fit(Chain.along(Drawn.line(0, 0, 100, 0), 20, 100), 0, 0, 1);
		final Fit bent = new Fit(Chain.along(Drawn.line(0, 0, 70, 0, 100, 8), 20, 100), 0, 0, 1);
		final List<Fit> pool = List.of(straight, bent);
		assertTrue(straight.chain().distance(bent.chain()) < TrackTuning.VISIBLE);
		for (final double dearer : new double[]{0, 0.05, 5}) {
			final TrellisPath path = new TrellisPath(new int[]{0}, new double[][]{{5, 5 + dearer}},
				5);
			final double most = FitConfidence.atMost(path, pool, 0, 1.4);
			assertEquals(dearer == 0 ? 0.5 : dearer < 1 ? 0.55 : 1, most, 0.01);
			assertEquals(1, FitConfidence.atMost(path, pool, 0, 6), 1e-9);
		}
	}

	@Test
	void theOrderOfStrandsThatCoverEachOtherMustBeSurelyCheaper() {
		final Fit crossing = new Fit(StrandExchangeTest.coil(14, true, false), 0, 0, 1);
		final Fit touching = new Fit(StrandExchangeTest.coil(14, false, false), 0, 0, 1);
		final Fit aside = new Fit(crossing.chain().shifted(4, 4), 0, 0, 1);
		final double sigma = 3.2, width = 2.355 * sigma;
		for (final Fit other : List.of(touching, aside)) {
			final double far = other.chain().farthest(crossing.chain());
			assertTrue(far < width && far > 0.6 * width, "" + far);
			for (final double dearer : new double[]{0, 1.2, 8})
				assertEquals(other == aside ? 1 : dearer == 0 ? 0.5 : dearer < 2 ? 0.85 : 1,
					FitConfidence.atMost(
						new TrellisPath(new int[]{0}, new double[][]{{5, 5 + dearer}}, 5),
						List.of(crossing, other), 0, sigma),
					0.01, (other == aside ? "aside " : "exchanged ") + dearer);
		}
	}

	private static Fit line(final double y) {
		return new Fit(Chain.along(Drawn.line(0, y, 50, y), 10, 50), 0, 0, 1);
	}

	private static Optional<FitQuality> quality(final double misfit) {
		return Optional.of(new FitQuality(misfit, 0));
	}
}
