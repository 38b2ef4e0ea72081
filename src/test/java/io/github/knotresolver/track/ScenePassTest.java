package io.github.knotresolver.track;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;

import org.junit.jupiter.api.Test;

import io.github.knotresolver.fit.Chain;
import io.github.knotresolver.fit.LineModel;
import io.github.knotresolver.fit.LineTables;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.progress.Progress;
import io.github.knotresolver.progress.Workers;

class ScenePassTest {

	private static final int SIZE = 70, FRAMES = 7, START = 2;
	private static final LineTables LINE = LineTables
		.together(LineModel.uniform(LineModel.Kind.ADDITIVE, 1.4, 1));

	/** A rod that glides to the right. */
	private static Chain rod(final int t) {
		final Polyline curve = Polyline.of(new double[]{10 + 2 * t, 40 + 2 * t},
			new double[]{30, 33});
		return Chain.inScene(curve, curve.length());
	}

	private static SceneLine seen() {
		final Random random = new Random(3);
		final List<FrameView> frames = new ArrayList<>();
		for (int t = 0; t < FRAMES; t++)
			frames.add(DrawnFrames.lit(t + 1, DrawnFrames.light(SIZE, LINE, List.of(rod(t))), 0.05,
				random));
		return new SceneLine(LINE, frames, 0.05);
	}

	@Test
	void bothWaysAreFollowedByThreadsOfTheirOwnToTheSameBits() {
		final SceneLine line = seen();
		final Set<Thread> threads = ConcurrentHashMap.newKeySet();
		final Progress noting = new Progress() {

			@Override
			public void report(final String stage, final double fraction) {
			}

			@Override
			public boolean isCancelled() {
				threads.add(Thread.currentThread());
				return false;
			}
		};
		final ScenePass alone = followed(line, Workers.HERE, Progress.NONE);
		assertEquals(FRAMES, alone.chains().size());
		for (int t = 0; t < FRAMES; t++)
			assertTrue(alone.chains().get(t).get(0).distance(rod(t)) < 0.5, "frame " + t);
		try (Workers two = new Workers(2)) {
			final ScenePass both = followed(line, two, noting);
			for (int t = 0; t < FRAMES; t++)
				assertEquals(alone.chains().get(t).get(0).polyline(),
					both.chains().get(t).get(0).polyline(), "frame " + t);
		}
		assertEquals(2, threads.size());
	}

	private static ScenePass followed(final SceneLine line, final Workers workers,
		final Progress progress) {
		return ScenePass.from(START, List.of(rod(START)), line, SceneWeights.DEFAULT, workers,
			progress);
	}
}
