
package io.github.knotresolver.track;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

import org.junit.jupiter.api.Test;

import io.github.knotresolver.Drawn;
import io.github.knotresolver.fit.Chain;
import io.github.knotresolver.fit.LineModel;
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
import io.github.knotresolver.track.SceneSettler.Settled;

class JoinedPiecesTest {

	private static final int SIZE = 130, FRAMES = 12;
	private static final LineTables LINE = LineTables
		.together(LineModel.uniform(LineModel.Kind.ADDITIVE, 1.4, 1));

	private static Chain rod(final double fromX, final double toX, final double y) {
		return Chain.inScene(Drawn.line(fromX, y, toX, y), toX - fromX);
	}

	/** Frames in which that is seen. */
	private static SceneLine seen(final List<List<Chain>> truth) {
		final List<FrameView> frames = new ArrayList<>();
		for (int t = 0; t < truth.size(); t++) {
			final NormalizedFrame dark = new NormalizedFrame(SIZE, SIZE, new double[SIZE * SIZE]);
			final NormalizedFrame lit = new Scene(dark, LINE, truth.get(t)).residual().rescaled(0,
				-1);
			final boolean[] bright = new boolean[SIZE * SIZE];
			for (int i = 0; i < bright.length; i++)
				bright[i] = lit.pixels()[i] > 0.5;
			frames.add(new FrameView(t + 1, lit, Pixels.mask(bright, SIZE),
				SkeletonGraph.of(Skeletonize.thin(Pixels.mask(bright, SIZE)))));
		}
		return new SceneLine(LINE, frames, 0.05);
	}

	private static Settled settled(final List<Chain> chains) {
		final double[] gap = new double[FRAMES];
		Arrays.fill(gap, 9);
		return new Settled(chains, gap, Double.NaN);
	}

	private static List<Settled> joined(final SceneLine line, final List<Settled> pieces) {
		return new JoinedPieces(line, SceneWeights.DEFAULT, Workers.HERE, Progress.NONE)
			.joined(pieces);
	}

	@Test
	void piecesThatFollowEachOtherAreOneFilamentWhicheverWayTheyRun() {
		final List<List<Chain>> truth = new ArrayList<>();
		final List<Chain> first = new ArrayList<>(), second = new ArrayList<>();
		for (int t = 0; t < FRAMES; t++) {
			truth.add(List.of(rod(10 + 2 * t, 90 + 2 * t, 60)));
			first.add(rod(10 + 2 * t, 52 + 2 * t, 60));
			second.add(rod(51 + 2 * t, 90 + 2 * t, 60).reversed());
		}
		final List<Settled> whole = joined(seen(truth), List.of(settled(first), settled(second)));
		assertEquals(1, whole.size());
		for (final Chain chain : whole.get(0).chains())
			assertEquals(80, chain.length(), 0.5);
	}

	@Test
	void filamentsThatMeetForAWhileAreTwo() {
		final List<List<Chain>> truth = new ArrayList<>();
		final List<Chain> first = new ArrayList<>(), second = new ArrayList<>();
		for (int t = 0; t < FRAMES; t++) {
			first.add(rod(10, 52, 60));
			second.add(rod(48 + 3 * t, 85 + 3 * t, 60));
			truth.add(List.of(first.get(t), second.get(t)));
		}
		assertEquals(2, joined(seen(truth), List.of(settled(first), settled(second))).size());
	}

	/** A track that turns back, which a filament runs through. */
	private static Polyline track() {
		final List<Point> points = new ArrayList<>();
		for (int x = 4; x <= 74; x++)
			points.add(new Point(x, 40));
		for (int angle = 3; angle < 180; angle += 3)
			points.add(new Point(74 + 10 * Math.sin(Math.toRadians(angle)),
				50 - 10 * Math.cos(Math.toRadians(angle))));
		for (int x = 74; x >= 0; x--)
			points.add(new Point(x, 60));
		return Polyline.of(points);
	}

	private static Chain onTrack(final double from, final double to) {
		final List<Point> points = new ArrayList<>();
		for (double s = from; s < to; s++)
			points.add(track().at(s));
		points.add(track().at(to));
		return Chain.inScene(Polyline.of(points), to - from);
	}

	@Test
	void aBendThatSlidesThroughWherePiecesMeetDoesNotPartThem() {
		final List<List<Chain>> truth = new ArrayList<>();
		final List<Chain> first = new ArrayList<>(), second = new ArrayList<>();
		for (int t = 0; t < FRAMES; t++) {
			final double s = 9 * t;
			truth.add(List.of(onTrack(s, s + 75)));
			first.add(onTrack(s, s + 30));
			second.add(onTrack(s + 30, s + 75));
		}
		final List<Settled> whole = joined(seen(truth), List.of(settled(first), settled(second)));
		assertEquals(1, whole.size());
		for (final Chain chain : whole.get(0).chains())
			assertEquals(75, chain.length(), 0.7);
	}

	@Test
	void twoThatAreHeldAtOnePlaceAreTwo() {
		final List<List<Chain>> truth = new ArrayList<>();
		final List<Chain> first = new ArrayList<>(), second = new ArrayList<>();
		for (int t = 0; t < FRAMES; t++) {
			first.add(ray(0.7 + 0.05 * t));
			second.add(ray(2.6 - 0.05 * t));
			truth.add(List.of(first.get(t), second.get(t)));
		}
		assertEquals(2, joined(seen(truth), List.of(settled(first), settled(second))).size());
	}

	/** From a fixed place in a direction. */
	private static Chain ray(final double angle) {
		return Chain
			.inScene(Drawn.line(65, 20, 65 + 60 * Math.cos(angle), 20 + 60 * Math.sin(angle)), 60);
	}
}
