
package io.github.knotresolver.track;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;

import org.junit.jupiter.api.Test;

import io.github.knotresolver.fit.Chain;
import io.github.knotresolver.fit.LineModel;
import io.github.knotresolver.fit.LineModel.Kind;
import io.github.knotresolver.fit.LineTables;
import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.progress.Progress;
import io.github.knotresolver.progress.Workers;

class FreeAgainTest {

	private static final int SIZE = 100, FRAMES = 32, OPEN = 14;
	private static final double NOISE = 0.1, LENGTH = 52, SPEED = 2.5, STEP = 0.25;

	/** Straight on, a turn of half a line's width, then ever narrower rings. */
	private static Polyline track() {
		final List<Point> points = new ArrayList<>(List.of(new Point(8, 52)));
		double heading = 0;
		for (int i = 1; i * STEP < LENGTH + SPEED * FRAMES + 1; i++) {
			final double s = i * STEP;
			heading += s < 80 ? 0 : STEP * (s < 88 ? 0.4 : 0.2 + 0.002 * (s - 88));
			final Point last = points.get(points.size() - 1);
			points.add(new Point(last.x() + STEP * Math.cos(heading),
				last.y() + STEP * Math.sin(heading)));
		}
		return Polyline.of(points);
	}

	/** The filament after it has slid along its track. */
	private static Chain glider(final int t) {
		final Polyline track = track();
		final List<Point> points = new ArrayList<>();
		for (double s = 0; s <= LENGTH; s += 1)
			points.add(track.at(SPEED * t + s));
		return Chain.along(Polyline.of(points), 35, LENGTH);
	}

	private static SceneLine line(final LineTables tables) {
		final Random random = new Random(3);
		final List<FrameView> frames = new ArrayList<>();
		for (int t = 0; t < FRAMES; t++)
			frames.add(DrawnFrames.lit(t + 1, DrawnFrames.light(SIZE, tables, List.of(glider(t))),
				NOISE, random));
		return new SceneLine(tables, frames, NOISE);
	}

	@Test
	void aGliderIsFollowedIntoARingThatItWindsUpItself() {
		final SceneLine line = line(LineTables.together(LineModel.uniform(Kind.ADDITIVE, 1.4, 1)));
		final List<List<Chain>> known = new ArrayList<>();
		final boolean[] clear = new boolean[FRAMES];
		Arrays.fill(clear, 0, OPEN, true);
		for (int t = 0; t < FRAMES; t++)
			known.add(List.of(Chain.inScene(glider(Math.min(t, OPEN)).polyline(), LENGTH)));
		final SceneSettler.Settled found = new FreeAgain(line, Workers.HERE, Progress.NONE)
			.follow(new ScenePass(0, known), 0, clear).orElseThrow();
		for (int t = 0; t < FRAMES; t++) {
			final Chain chain = found.chains().get(t);
			assertEquals(LENGTH, chain.length(), 1e-9);
			final double off = SceneSeed.oneWay(chain.polyline(), glider(t).polyline());
			assertTrue(off < 1.5, "frame " + (t + 1) + ": " + off);
			assertTrue(found.gap()[t] > 0, "frame " + (t + 1));
		}
	}

	@Test
	void whereAGliderIsBackOnItsKnownCourseThatIsKept() {
		final SceneLine line = line(LineTables.together(LineModel.uniform(Kind.ADDITIVE, 1.4, 1)));
		final List<List<Chain>> known = new ArrayList<>();
		final boolean[] clear = new boolean[FRAMES];
		for (int t = 0; t < FRAMES; t++) {
			clear[t] = t < OPEN || t > OPEN + 2;
			known.add(List.of(Chain.inScene(glider(clear[t] ? t : OPEN - 1).polyline(), LENGTH)));
		}
		final SceneSettler.Settled found = new FreeAgain(line, Workers.HERE, Progress.NONE)
			.follow(new ScenePass(0, known), 0, clear).orElseThrow();
		for (int t = 0; t < FRAMES; t++) {
			final double off = SceneSeed.oneWay(found.chains().get(t).polyline(),
				glider(t).polyline());
			assertTrue(off < 1.5, "frame " + (t + 1) + ": " + off);
			assertTrue(t < OPEN || t > OPEN + 2 || found.gap()[t] < Double.POSITIVE_INFINITY);
		}
		assertEquals(Double.POSITIVE_INFINITY, found.gap()[1]);
	}

	@Test
	void whatIsNeverClearForLongIsNotFollowedAgain() {
		final SceneLine line = line(LineTables.together(LineModel.uniform(Kind.ADDITIVE, 1.4, 1)));
		final List<List<Chain>> known = new ArrayList<>();
		final boolean[] clear = new boolean[FRAMES];
		for (int t = 0; t < FRAMES; t++) {
			known.add(List.of(Chain.inScene(glider(t).polyline(), LENGTH)));
			clear[t] = t % 6 > 0;
		}
		assertTrue(new FreeAgain(line, Workers.HERE, Progress.NONE)
			.follow(new ScenePass(0, known), 0, clear).isEmpty());
	}
}
