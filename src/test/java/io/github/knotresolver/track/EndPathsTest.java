package io.github.knotresolver.track;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.function.IntFunction;

import org.junit.jupiter.api.Test;

import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.progress.Progress;
import io.github.knotresolver.track.EndPaths.End;
import io.github.knotresolver.track.EndPaths.EndPath;

class EndPathsTest {

	private static final int FRAMES = 30;

	private static List<End> ends(final List<IntFunction<Point>> moving) {
		final List<End> ends = new ArrayList<>();
		for (int t = 0; t < FRAMES; t++)
			for (final IntFunction<Point> end : moving)
				if (end.apply(t) != null)
					ends.add(new End(t, end.apply(t), 0, 100));
		return ends;
	}

	private static Point tip(final int t) {
		return new Point(80, 50 + 30 * Math.sin(0.5 * t));
	}

	/** All ends of a path are the right ones, and few are missing. */
	private static void assertFollows(final IntFunction<Point> truth, final EndPath path,
		final int seen) {
		assertTrue(path.ends().size() >= seen - 2, path.ends().size() + " of " + seen);
		for (final End e : path.ends())
			assertEquals(truth.apply(e.frame()), e.at(), "frame " + e.frame());
	}

	@Test
	void anEndThatDriftsGoesBeforeOneThatSweeps() {
		final IntFunction<Point> clamp = t -> new Point(20 + 0.3 * t, 50 - 0.2 * t);
		assertFollows(clamp,
			EndPaths.best(ends(List.of(EndPathsTest::tip, clamp)), 2, Progress.NONE).get(0),
			FRAMES);
	}

	@Test
	void aJumpIsFollowed() {
		final IntFunction<Point> clamp = t -> t < 18 ? new Point(20, 50) : new Point(29, 44);
		assertFollows(clamp,
			EndPaths
				.past(ends(List.of(clamp, EndPathsTest::tip)), new Point(21, 50), 8, Progress.NONE)
				.orElseThrow(),
			FRAMES);
	}

	@Test
	void whereTheEndIsHiddenThePathDoesNotHopToTheTip() {
		final Random random = new Random(1);
		final List<Point> jitter = new ArrayList<>();
		for (int t = 0; t < FRAMES; t++)
			jitter.add(new Point(20 + random.nextGaussian(), 50 + random.nextGaussian()));
		final IntFunction<Point> clamp = t -> t > 8 && t < 20 ? null : jitter.get(t);
		assertFollows(clamp,
			EndPaths.best(ends(List.of(EndPathsTest::tip, clamp)), 1, Progress.NONE).get(0),
			FRAMES - 11);
	}

	/** A filament that contracts towards its clamp, of which the skeletons miss the end now and then. */
	@Test
	void theEndAtThePlaceGoesBeforeATipThatComesNear() {
		final IntFunction<Point> clamp = t -> t % 2 == 1 ? null : new Point(20 + t / 2 % 2, 50),
			tip = t -> new Point(29 + 2.4 * (FRAMES - 1 - t), 50);
		assertFollows(clamp, EndPaths
			.past(ends(List.of(tip, clamp)), new Point(21, 50), 8, Progress.NONE).orElseThrow(),
			FRAMES / 2);
	}

	@Test
	void nothingIsFoundFarFromAnyEnd() {
		final List<End> ends = ends(List.of(EndPathsTest::tip));
		assertTrue(EndPaths.past(ends, new Point(10, 10), 8, Progress.NONE).isEmpty());
		assertTrue(EndPaths.best(List.of(), 3, Progress.NONE).isEmpty());
	}
}
