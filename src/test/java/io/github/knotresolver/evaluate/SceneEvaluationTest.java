package io.github.knotresolver.evaluate;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Map;
import java.util.SortedMap;
import java.util.TreeMap;

import org.junit.jupiter.api.Test;

import io.github.knotresolver.evaluate.SceneEvaluation.FilamentScore;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.model.UserException;
import io.github.knotresolver.progress.Progress;

/** Straight filaments, so that every figure can be counted by hand. */
class SceneEvaluationTest {

	private static final int FRAMES = 10;

	/** Filament 1 is horizontal, 2 crosses it vertically, 3 lies apart. */
	private final SortedMap<Integer, SortedMap<Integer, Polyline>> truth = new TreeMap<>(
		Map.of(1, everywhere(line(0, 50, 100, 50)), 2, everywhere(line(50, 0, 50, 100)), 3,
			everywhere(line(0, 200, 60, 200))));
	private final SortedMap<Integer, SortedMap<Integer, Polyline>> result = new TreeMap<>();
	private final Map<Integer, Map<Integer, Double>> confidence = new TreeMap<>();

	@Test
	void truthItselfIsPerfectWhateverItsNumbers() {
		result.put(7, truth.get(1));
		result.put(4, truth.get(2));
		result.put(9, truth.get(3));
		final SceneEvaluation s = score();
		assertEquals(30, s.frames());
		assertEquals(20, s.crossingFrames());
		assertEquals(100, s.percentResolved());
		assertEquals(100, s.percentResolvedCrossing());
		assertEquals(100, s.percentFound());
		assertEquals(0, s.switches());
		assertEquals(0, s.percentFalse());
		assertEquals(100, s.percentRightWay());
		assertEquals(7, s.filaments().get(0).result().getAsInt());
		assertEquals(0, s.meanErrorResolved(), 1e-6);
		assertTrue(Double.isNaN(s.percentSilent()));
	}

	@Test
	void exchangedIdentitiesAreSwitchesAndNotResolved() {
		result.put(1, everywhere(line(0, 50, 100, 50)));
		result.put(2, everywhere(line(50, 0, 50, 100)));
		for (int t = 4; t <= 6; t++) {
			result.get(1).put(t, line(50, 0, 50, 100));
			result.get(2).put(t, line(0, 50, 100, 50));
		}
		final SceneEvaluation s = score();
		assertEquals(14, s.resolved());
		assertEquals(20, s.found());
		assertEquals(4, s.switches());
		assertEquals(0, s.wrong());
		assertEquals(2, s.filaments().stream().filter(FilamentScore::isGiven).count());
	}

	@Test
	void oneDirectionCountsForTheWholeMovie() {
		result.put(1, everywhere(line(100, 50, 0, 50)));
		result.get(1).put(3, line(0, 50, 100, 50));
		final SceneEvaluation s = score();
		assertEquals(9, s.resolved());
		assertEquals(10, s.found());
		assertEquals(0, s.percentRightWay());
		assertTrue(s.filaments().get(0).reversed());
	}

	@Test
	void whatIsNoFilamentIsFalseAndSilentIfItIsSure() {
		result.put(1, everywhere(line(0, 50, 100, 50)));
		result.put(2, everywhere(line(300, 300, 350, 300)));
		result.get(2).put(FRAMES + 5, line(0, 50, 100, 50));
		confidence.put(2, new TreeMap<>(Map.of(1, 0.95, 2, 0.95, 3, 0.5)));
		final SceneEvaluation s = score();
		assertEquals(21, s.shown());
		assertEquals(11, s.wrong());
		assertEquals(2, s.silent());
		assertEquals(10, s.resolved());
		assertEquals(100 * 2 / 21.0, s.percentSilent(), 1e-9);
	}

	@Test
	void halfOfAFilamentIsNotIt() {
		result.put(1, everywhere(line(0, 50, 48, 50)));
		assertEquals(0, score().found());
		result.put(1, everywhere(line(0, 53, 97, 53)));
		assertEquals(10, score().resolved());
		result.put(1, everywhere(line(0, 56, 100, 56)));
		assertEquals(0, score().found());
	}

	@Test
	void noTruthIsRefused() {
		truth.clear();
		assertThrows(UserException.class, this::score);
	}

	private SceneEvaluation score() {
		return SceneEvaluation.of(truth, result, confidence, Progress.NONE);
	}

	private static Polyline line(final double x0, final double y0, final double x1,
		final double y1) {
		return Polyline.of(new double[]{x0, x1}, new double[]{y0, y1});
	}

	private static SortedMap<Integer, Polyline> everywhere(final Polyline contour) {
		final SortedMap<Integer, Polyline> frames = new TreeMap<>();
		for (int t = 1; t <= FRAMES; t++)
			frames.put(t, contour);
		return frames;
	}
}
