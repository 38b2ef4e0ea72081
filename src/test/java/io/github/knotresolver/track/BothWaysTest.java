
package io.github.knotresolver.track;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.BitSet;
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

class BothWaysTest {

	private static final int SIZE = 90, FRAMES = 12;
	private static final double NOISE = 0.1, LENGTH = 45, SPEED = 2.5;
	private static final LineTables LINE = LineTables
		.together(LineModel.uniform(Kind.ADDITIVE, 1.4, 1));

	/** A filament that glides around a bend. */
	private static Chain glider(final int t) {
		final List<Point> points = new ArrayList<>();
		for (double s = SPEED * t; s <= SPEED * t + LENGTH + 0.5; s += 0.5)
			points.add(new Point(10 + 0.8 * s, 45 + 18 * Math.sin(s / 14)));
		return Chain.along(Polyline.of(points), 30, LENGTH);
	}

	private static SceneLine movie() {
		final Random random = new Random(5);
		final List<FrameView> frames = new ArrayList<>();
		for (int t = 0; t < FRAMES; t++)
			frames.add(DrawnFrames.lit(t + 1, DrawnFrames.light(SIZE, LINE, List.of(glider(t))),
				NOISE, random));
		return new SceneLine(LINE, frames, NOISE);
	}

	private static List<Chain> gliders() {
		final List<Chain> all = new ArrayList<>();
		for (int t = 0; t < FRAMES; t++)
			all.add(glider(t));
		return all;
	}

	private static BothWays both(final List<Chain> chains) {
		return new BothWays(movie(), SceneWeights.SUPPLE,
			new ScenePass(0, chains.stream().map(List::of).toList()), 0);
	}

	@Test
	void whatWasLostForSomeFramesIsFoundFromTheFramesAfterThem() {
		final List<Chain> chains = gliders();
		// Lost in frame 4, found again in frame 8.
		for (int t = 3; t < 7; t++)
			chains.set(t, glider(t).shifted(0, 14));
		both(gliders()).settle(chains, chains, all(chains), Progress.NONE);
		for (int t = 0; t < FRAMES; t++) {
			final int frame = t;
			assertEquals(LENGTH, chains.get(t).length(), 1e-9);
			assertTrue(chains.get(t).farthest(glider(t)) < 1.5,
				() -> "frame " + (frame + 1) + ": " + chains.get(frame).farthest(glider(frame)));
		}
	}

	@Test
	void ofTwoCoursesEachFrameTakesTheCheaperOne() {
		final List<Chain> chains = gliders(), other = gliders();
		// Farther off than a fit finds back, and to the last frame.
		for (int t = 0; t < FRAMES; t++)
			(t < 6 ? other : chains).set(t, glider(t).shifted(0, 25));
		both(gliders()).settle(chains, other, all(chains), Progress.NONE);
		for (int t = 0; t < FRAMES; t++)
			assertTrue(chains.get(t).farthest(glider(t)) < 1.5, "frame " + (t + 1));
	}

	@Test
	void whatIsRightStaysAsItIs() {
		final List<Chain> chains = gliders(), before = List.copyOf(chains);
		both(before).settle(chains, chains, all(chains), Progress.NONE);
		for (int t = 0; t < FRAMES; t++)
			assertSame(before.get(t), chains.get(t), "frame " + (t + 1));
	}

	private static BitSet all(final List<Chain> chains) {
		final BitSet all = new BitSet();
		all.set(0, chains.size());
		return all;
	}
}
