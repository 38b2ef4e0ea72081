
package io.github.knotresolver.track;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import io.github.knotresolver.fit.Chain;
import io.github.knotresolver.fit.LineModel;
import io.github.knotresolver.fit.LineModel.Kind;
import io.github.knotresolver.fit.LineTables;
import io.github.knotresolver.fit.NormalizedFrame;
import io.github.knotresolver.fit.Scene;
import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.graph.SkeletonGraph;
import io.github.knotresolver.image.Pixels;
import io.github.knotresolver.progress.Progress;
import io.github.knotresolver.progress.Workers;
import io.github.knotresolver.skeleton.Skeletonize;

class SceneLineTest {

	private static final int SIZE = 120;

	/** A straight line of a width, its ridge found. */
	private static FrameView frame(final int t, final double sigma) {
		final NormalizedFrame dark = new NormalizedFrame(SIZE, SIZE, new double[SIZE * SIZE]);
		final Chain chain = Chain
			.inScene(Polyline.of(new double[]{15, 105}, new double[]{50 + t, 60}), 90);
		final double[] light = new Scene(dark,
			LineTables.together(LineModel.uniform(Kind.ADDITIVE, sigma, 1)), List.of(chain))
			.residual().pixels();
		final boolean[] ridge = new boolean[light.length];
		for (int i = 0; i < light.length; i++) {
			light[i] = -light[i];
			ridge[i] = light[i] > 0.9;
		}
		return new FrameView(t + 1, new NormalizedFrame(SIZE, SIZE, light),
			Pixels.mask(ridge, SIZE), SkeletonGraph.of(Skeletonize.thin(Pixels.mask(ridge, SIZE))));
	}

	private static double sigma(final double drawn) {
		final List<FrameView> frames = new ArrayList<>();
		for (int t = 0; t < 3; t++)
			frames.add(frame(t, drawn));
		return SceneLine.learn(frames, List.of(Kind.ADDITIVE), Workers.HERE, Progress.NONE).tables()
			.model().sigma();
	}

	/** Three filaments that cross each other, and what is brighter than half of one. */
	private static FrameView crossed(final int t, final LineModel line) {
		final NormalizedFrame dark = new NormalizedFrame(SIZE, SIZE, new double[SIZE * SIZE]);
		final List<Chain> chains = List.of(
			Chain.inScene(Polyline.of(new double[]{15, 105}, new double[]{30 + t, 40}), 91),
			Chain.inScene(Polyline.of(new double[]{30, 35 + t}, new double[]{15, 105}), 90),
			Chain.inScene(Polyline.of(new double[]{90 - t, 60}, new double[]{20, 105}), 90));
		return seen(t, new Scene(dark, LineTables.together(line), chains), new Random(t));
	}

	/** What is drawn, with noise, and what of it is brighter than half of one. */
	private static FrameView seen(final int t, final Scene scene, final Random random) {
		final double[] light = scene.residual().pixels();
		final boolean[] bright = new boolean[light.length];
		for (int i = 0; i < light.length; i++) {
			bright[i] = light[i] < -0.5;
			light[i] = 0.05 * random.nextGaussian() - light[i];
		}
		return new FrameView(t + 1, new NormalizedFrame(SIZE, SIZE, light),
			Pixels.mask(bright, SIZE),
			SkeletonGraph.of(Skeletonize.thin(Pixels.mask(bright, SIZE))));
	}

	@ParameterizedTest
	@CsvSource({"ADDITIVE,1", "BRIGHTEST,1", "SATURATING,1.8"})
	void crossingsTellWhetherLightAddsUpAndEndsWhetherTheyAreBlurred(final Kind kind,
		final double power) {
		final List<FrameView> frames = new ArrayList<>();
		for (int t = 0; t < 6; t++)
			frames.add(crossed(t, LineModel.uniform(kind, 1.4, power)));
		assertEquals(kind,
			SceneLine
				.learn(frames, List.of(Kind.SATURATING, Kind.ADDITIVE), Workers.HERE, Progress.NONE)
				.tables().model().kind());
	}

	/** A filament that lies open at first, then runs into rings that it winds up itself. */
	private static FrameView wound(final int t, final Random random, final LineModel line) {
		final double length = 86, from = 5.11 * Math.max(0, t - 4);
		double x = 20, y = 60, heading = 0;
		final List<Point> points = new ArrayList<>();
		for (double s = 0; s <= from + length; s += 0.5) {
			heading += s < length ? 0 : 0.5 * (0.208 + 0.117 * Math.sin(0.317 * (s - length)));
			x += 0.5 * Math.cos(heading);
			y += 0.5 * Math.sin(heading);
			if (s >= from)
				points.add(new Point(x - from * 0.6, y));
		}
		final NormalizedFrame dark = new NormalizedFrame(SIZE, SIZE, new double[SIZE * SIZE]);
		final Chain chain = Chain.along(Polyline.of(points), 57, length);
		return seen(t, new Scene(dark, LineTables.together(line), List.of(chain)), random);
	}

	@ParameterizedTest
	@CsvSource({"ADDITIVE,1", "BRIGHTEST,1"})
	void whatIsWoundUpAndNowhereAsBrightAsTwoDoesNotAddUp(final Kind kind, final double power) {
		for (int seed = 0; seed < 3; seed++) {
			final Random random = new Random(seed);
			final List<FrameView> frames = new ArrayList<>();
			for (int t = 0; t < 14; t++)
				frames.add(wound(t, random, LineModel.uniform(kind, 1.4, power)));
			assertEquals(kind, SceneLine
				.learn(frames, List.of(Kind.SATURATING, Kind.ADDITIVE), Workers.HERE, Progress.NONE)
				.tables().model().kind(), "noise " + seed);
		}
	}

	@Test
	void aLineIsAsWideAsItLooks() {
		assertEquals(2, sigma(2), 0.1);
	}

	@Test
	void whatIsWiderThanLinesAreIsNotLearned() {
		assertEquals(1.5, sigma(9), 0);
	}
}
