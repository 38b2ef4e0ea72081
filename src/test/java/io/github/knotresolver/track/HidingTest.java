
package io.github.knotresolver.track;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

import net.imglib2.img.Img;
import net.imglib2.type.logic.BitType;

import org.junit.jupiter.api.Test;

import io.github.knotresolver.Drawn;
import io.github.knotresolver.fit.Chain;
import io.github.knotresolver.fit.LineModel;
import io.github.knotresolver.fit.LineTables;
import io.github.knotresolver.fit.NormalizedFrame;
import io.github.knotresolver.fit.Scene;
import io.github.knotresolver.graph.SkeletonGraph;
import io.github.knotresolver.image.Pixels;
import io.github.knotresolver.model.Observation;
import io.github.knotresolver.model.Settings.AnchorChoice;
import io.github.knotresolver.track.SceneSettler.Settled;

/** A short filament that glides along a long one: over its end, and then all of it under it. */
class HidingTest {

	private static final int SIZE = 120, FRAMES = 20;

	private static final double END_OF_LONG = 90;

	private final Hiding hiding = new Hiding(SceneWeights.DEFAULT);

	private static Chain straight(final double fromX, final double toX, final double y) {
		return Chain.along(Drawn.line(fromX, y, toX, y), 20, toX - fromX);
	}

	/** A short filament whose last point is there, and a long one, both seen as they are. */
	private static Scene scene(final LineModel.Kind kind, final double tip) {
		final LineTables line = LineTables.together(LineModel.uniform(kind, 1.4, 1));
		final List<Chain> chains = List.of(straight(tip - 30, tip, 60.3),
			straight(15, END_OF_LONG, 60));
		final NormalizedFrame dark = new NormalizedFrame(SIZE, SIZE, new double[SIZE * SIZE]);
		// What is drawn in the dark is too much.
		final NormalizedFrame lit = new Scene(dark, line, chains).residual().rescaled(0, -1);
		return new Scene(lit, line, chains);
	}

	private double confidence(final Scene scene) {
		return new SceneConfidence(hiding.gap(scene, 0), 0, 0, 1, 0).value();
	}

	@Test
	void aFilamentUnderAnotherOneIsDoubtfulHoweverWellAllIsExplained() {
		final Scene scene = scene(LineModel.Kind.SATURATING, 60);
		assertTrue(new Unexplained(scene, 0.05).worst(scene.chain(0)) < 1e-9);
		assertTrue(confidence(scene) < 0.5, "confidence " + confidence(scene));
		assertTrue(confidence(scene) >= SceneTuning.LEAST_OF_HIDDEN - 1e-9);
	}

	@Test
	void oneEndInTheOpenTellsWhereItIs() {
		final Scene scene = scene(LineModel.Kind.SATURATING, END_OF_LONG + 10);
		assertTrue(confidence(scene) > 0.95, "confidence " + confidence(scene));
	}

	@Test
	void theLongOneIsSeenWhereverTheShortOneIs() {
		assertTrue(hiding.shown(scene(LineModel.Kind.SATURATING, 60), 1) > 4);
	}

	@Test
	void whereLightAddsUpNothingIsHidden() {
		assertEquals(1, confidence(scene(LineModel.Kind.ADDITIVE, 60)), 1e-12);
	}

	@Test
	void theSceneStaysAsItIs() {
		final Scene scene = scene(LineModel.Kind.SATURATING, 60);
		final double[] before = scene.residual().pixels().clone();
		hiding.shown(scene, 0);
		assertArrayEquals(before, scene.residual().pixels(), 0);
	}

	/** As the short one glides under the long one, 3 px from frame to frame. */
	@Test
	void theMovieIsDoubtfulWhereAndOnlyWhereTheFilamentIsHidden() {
		final List<Chain> shorts = new ArrayList<>(), longs = new ArrayList<>();
		final List<FrameView> frames = new ArrayList<>();
		LineTables line = null;
		for (int t = 0; t < FRAMES; t++) {
			final Scene scene = scene(LineModel.Kind.SATURATING, 112 - 3 * t);
			line = scene.line();
			shorts.add(scene.chain(0));
			longs.add(scene.chain(1));
			final Img<BitType> mask = Pixels.mask(new boolean[SIZE * SIZE], SIZE);
			frames.add(new FrameView(t + 1, scene.light(), mask, SkeletonGraph.of(mask)));
		}
		final boolean[][] clear = new boolean[2][FRAMES];
		final double[] sure = new double[FRAMES];
		Arrays.fill(clear[0], true);
		Arrays.fill(clear[1], true);
		Arrays.fill(sure, 100);
		final List<Observation> found = SceneTracks.of(new SceneLine(line, frames, 0.05),
			List.of(new Settled(longs, sure, 0), new Settled(shorts, sure, 0)), clear,
			AnchorChoice.FREE).filaments().get(1).frames();
		assertTrue(found.get(0).confidence() > 0.95, found.get(0).toString());
		assertTrue(found.get(FRAMES - 1).confidence() < 0.5, found.get(FRAMES - 1).toString());
		assertTrue(found.get(FRAMES - 1).reason().contains("another course"),
			found.get(FRAMES - 1).reason());
	}
}
