package io.github.knotresolver.evaluate;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.OptionalInt;
import java.util.Random;
import java.util.SortedMap;
import java.util.TreeMap;

import org.junit.jupiter.api.Test;

import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.model.UserException;
import io.github.knotresolver.progress.Progress;

class EvaluationTest {

	private static final Polyline LINE = Polyline.of(new double[]{0, 20}, new double[]{0, 0});
	private static final Polyline LOOP = Polyline.of(new double[]{0, 10, 10, 5.3, 5.3},
		new double[]{0, 0.3, 5, 5, -5});

	@Test
	void countsMissingFlippedCrossedAndExtraFrames() {
		final SortedMap<Integer, Polyline> truth = new TreeMap<>(), result = new TreeMap<>();
		for (int frame = 1; frame <= 4; frame++)
			truth.put(frame, frame == 2 ? LOOP : LINE);
		result.put(1, LINE);
		result.put(2, LOOP);
		result.put(3, LINE.reversed());
		result.put(9, LINE);
		final EvaluationSummary s = Evaluation.of(truth, result, Progress.NONE).summary();
		assertEquals(4, s.frames());
		assertEquals(3, s.framesPresent());
		assertEquals(1, s.framesWithCrossings());
		assertEquals(1, s.extraResultFrames());
		assertEquals(0.75, s.meanDice(), 1e-12);
		assertEquals(50, s.percentResolved(), 1e-12);
		assertEquals(100, s.percentResolvedCrossingFrames(), 1e-12);
		assertEquals(100 / 3.0, s.percentResolvedSimpleFrames(), 1e-12);
		assertEquals(1, s.framesFlipped());
		assertEquals(OptionalInt.of(3), s.firstUnresolvedFrame());
		assertEquals(10, s.medianFrechet(), 1e-12);
		assertEquals(0, s.medianFrechetPresent(), 1e-12);
	}

	@Test
	void withoutResultEverythingIsMissing() {
		final SortedMap<Integer, Polyline> truth = new TreeMap<>();
		truth.put(1, LINE);
		final EvaluationSummary s = Evaluation.of(truth, new TreeMap<>(), Progress.NONE).summary();
		assertEquals(0, s.meanDice());
		assertEquals(Double.POSITIVE_INFINITY, s.medianFrechet());
		assertTrue(Double.isNaN(s.meanError()));
		assertTrue(Double.isNaN(s.percentResolvedCrossingFrames()));
	}

	@Test
	void truthMustHaveFramesWithLength() {
		assertThrows(UserException.class,
			() -> Evaluation.of(new TreeMap<>(), new TreeMap<>(), Progress.NONE));
		final SortedMap<Integer, Polyline> truth = new TreeMap<>();
		truth.put(7, LINE.head(0));
		assertEquals("truth has a contour without length in frame 7; give it two points or more.",
			assertThrows(UserException.class,
				() -> Evaluation.of(truth, new TreeMap<>(), Progress.NONE)).getMessage());
	}

	@Test
	void aHistogramOfGaussianErrorsGivesBackTheirMeanAndSigma() {
		final Random random = new Random(5);
		final double[] errors = random.doubles(20_000).map(u -> 1.5 + 0.3 * random.nextGaussian())
			.toArray();
		final ErrorHistogram h = ErrorHistogram.of(errors, 0.1);
		assertEquals(1.5, h.gaussian().orElseThrow().mean(), 0.01);
		assertEquals(0.3, h.gaussian().orElseThrow().sigma(), 0.01);
		assertEquals(h.density()[15], h.gaussian().orElseThrow().at(1.55), 0.05);
		double area = 0;
		for (final double d : h.density())
			area += d * 0.1;
		assertEquals(1, area, 1e-9);
	}

	@Test
	void errorsFallIntoTheBinThatHoldsThem() {
		final ErrorHistogram h = ErrorHistogram.of(new double[]{0, 0.4, 0.5, 1.2}, 0.5);
		assertArrayEquals(new double[]{1, 0.5, 0.5}, h.density(), 1e-12);
	}

	@Test
	void tooFewBinsHaveNoGaussian() {
		assertTrue(ErrorHistogram.of(new double[]{0.1, 0.2}, 1).gaussian().isEmpty());
		assertTrue(ErrorHistogram.of(new double[0], 1).gaussian().isEmpty());
	}
}
