package io.github.knotresolver.track;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import java.util.Set;
import java.util.function.IntFunction;
import java.util.stream.IntStream;

import org.junit.jupiter.api.Test;

import io.github.knotresolver.fit.Chain;
import io.github.knotresolver.fit.LineModel;
import io.github.knotresolver.fit.LineModel.Kind;
import io.github.knotresolver.fit.LineTables;
import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.progress.Progress;
import io.github.knotresolver.progress.Workers;
import io.github.knotresolver.track.SceneSettler.Settled;

class SceneRefinementTest {

	private static final int SIZE = 110, FRAMES = 12;
	private static final LineTables LINE = LineTables
		.together(LineModel.uniform(Kind.ADDITIVE, 1.4, 1));

	private static FrameView frame(final int t, final List<Chain> chains, final Random random) {
		return DrawnFrames.lit(t + 1, DrawnFrames.light(SIZE, LINE, chains), 0.05, random);
	}

	private static SceneRefinement refinement(final List<List<Chain>> movie) {
		final Random random = new Random(3);
		final List<FrameView> frames = new ArrayList<>();
		for (int t = 0; t < FRAMES; t++)
			frames.add(frame(t, movie.get(t), random));
		return new SceneRefinement(
			SceneLine.learn(frames, Set.of(Kind.ADDITIVE), Workers.HERE, Progress.NONE),
			SceneWeights.DEFAULT, Workers.HERE, Progress.NONE);
	}

	/** Held at (25, 55), it beats and makes a loop. */
	private static Polyline looped(final int t) {
		final double[] x = new double[100], y = new double[100];
		x[0] = 25;
		y[0] = 55;
		for (int i = 1; i < x.length; i++) {
			final double angle = 0.3 * Math.sin(0.6 * t) - 0.5
				+ i * (0.06 + 0.008 * Math.sin(0.4 * t));
			x[i] = x[i - 1] + Math.cos(angle);
			y[i] = y[i - 1] + Math.sin(angle);
		}
		return Polyline.of(x, y);
	}

	private static Chain part(final Polyline curve, final int from, final int to) {
		final Polyline part = Polyline
			.of(IntStream.rangeClosed(from, to).mapToObj(curve::point).toList());
		return Chain.inScene(part, part.length());
	}

	private static Chain rod(final double x, final double y, final double length) {
		return Chain.inScene(Polyline.of(List.of(new Point(x, y), new Point(x + length, y))),
			length);
	}

	private static Settled followed(final IntFunction<Chain> chain) {
		final double[] gap = new double[FRAMES];
		Arrays.fill(gap, 50);
		return new Settled(IntStream.range(0, FRAMES).mapToObj(chain).toList(), gap, 0.1);
	}

	@Test
	void aFilamentThatLiesOnItselfIsWholeAlsoIfItWasFollowedInPieces() {
		final IntFunction<Chain> glider = t -> rod(15 + 3 * t, 98, 40);
		final List<List<Chain>> movie = IntStream.range(0, FRAMES)
			.mapToObj(t -> List.of(part(looped(t), 0, 99), glider.apply(t))).toList();
		final List<Settled> found = refinement(movie)
			.refine(List.of(followed(t -> part(looped(t), 0, 40)), followed(glider),
				followed(t -> part(looped(t), 41, 99))));
		assertEquals(2, found.size());
		final Settled whole = found.stream().filter(f -> f.chains().get(0).length() > 60)
			.findFirst().orElseThrow();
		for (int t = 0; t < FRAMES; t++)
			assertTrue(
				SceneSeed.oneWay(looped(t), whole.chains().get(t).polyline()) < 1
					&& whole.chains().get(t).start().distanceTo(looped(t).first()) < 2,
				"frame " + (t + 1));
	}

	@Test
	void filamentsThatTouchStayTwo() {
		final IntFunction<Chain> one = t -> part(looped(t), 0, 60);
		final IntFunction<Chain> other = t -> rod(20 + t, 52, 60);
		final IntFunction<Chain> third = t -> rod(15 + 3 * t, 98, 40);
		final List<Settled> found = List.of(followed(one), followed(other), followed(third));
		final List<List<Chain>> movie = IntStream.range(0, FRAMES)
			.mapToObj(t -> List.of(one.apply(t), other.apply(t), third.apply(t))).toList();
		assertEquals(List.of(0, 1), ScenePass.of(found).touching(1));
		assertEquals(List.of(2), ScenePass.of(found).touching(2));
		assertSame(found, refinement(movie).refine(found));
	}

	@Test
	void whereHardlyAnythingIsExplainedNothingIsTriedAgain() {
		final List<List<Chain>> movie = IntStream.range(0, FRAMES)
			.mapToObj(t -> List.of(part(looped(t), 0, 99))).toList();
		final List<Settled> found = List.of(followed(t -> part(looped(t), 0, 49)),
			followed(t -> part(looped(t), 60, 99)));
		assertSame(found, refinement(movie).refine(found));
	}
}
