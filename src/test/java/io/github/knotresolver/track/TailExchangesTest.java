
package io.github.knotresolver.track;

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
import io.github.knotresolver.fit.NormalizedFrame;
import io.github.knotresolver.fit.Scene;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.graph.SkeletonGraph;
import io.github.knotresolver.image.Pixels;
import io.github.knotresolver.progress.Progress;
import io.github.knotresolver.progress.Workers;
import io.github.knotresolver.track.SceneSettler.Settled;

/** Two filaments of one length that glide through one point at the same time. */
class TailExchangesTest {

	private static final int SIZE = 130, FRAMES = 12;
	private static final double NOISE = 0.05, LENGTH = 60, ANGLE = 0.3;
	private static final LineTables LINE = LineTables
		.together(LineModel.uniform(Kind.ADDITIVE, 1.4, 1));

	/** The point at (65, 65) is that far from a filament's first point. */
	private static double crossing(final int t) {
		return 50 - 3 * t;
	}

	private static Chain rod(final int t, final double angle) {
		return chain(65 - crossing(t) * Math.cos(angle), 65 - crossing(t) * Math.sin(angle), angle,
			angle, crossing(t));
	}

	/** It turns at the point where they cross. */
	private static Chain exchanged(final int t, final double from, final double to) {
		return chain(65 - crossing(t) * Math.cos(from), 65 - crossing(t) * Math.sin(from), from, to,
			crossing(t));
	}

	private static Chain chain(final double x, final double y, final double from, final double to,
		final double turnsAt) {
		final double mx = x + turnsAt * Math.cos(from), my = y + turnsAt * Math.sin(from);
		return Chain
			.inScene(Polyline.of(new double[]{x, mx, mx + (LENGTH - turnsAt) * Math.cos(to)},
				new double[]{y, my, my + (LENGTH - turnsAt) * Math.sin(to)}), LENGTH);
	}

	private static FrameView frame(final int t, final double angle, final Random random) {
		final double[] light = new Scene(new NormalizedFrame(SIZE, SIZE, new double[SIZE * SIZE]),
			LINE, List.of(rod(t, angle), rod(t, -angle))).residual().pixels();
		for (int i = 0; i < light.length; i++)
			light[i] = NOISE * random.nextGaussian() - light[i];
		return new FrameView(t + 1, new NormalizedFrame(SIZE, SIZE, light),
			Pixels.mask(new boolean[light.length], SIZE),
			SkeletonGraph.of(Pixels.mask(new boolean[light.length], SIZE)));
	}

	private static List<Settled> checked(final int from) {
		final List<Chain> a = new ArrayList<>(), b = new ArrayList<>();
		for (int t = 0; t < FRAMES; t++) {
			a.add(t < from ? rod(t, ANGLE) : exchanged(t, ANGLE, -ANGLE));
			b.add(t < from ? rod(t, -ANGLE) : exchanged(t, -ANGLE, ANGLE));
		}
		return checked(ANGLE, a, b);
	}

	/** Two chains where rods cross, each at an angle to the horizontal. */
	private static List<Settled> checked(final double angle, final List<Chain> a,
		final List<Chain> b) {
		final Random random = new Random(3);
		final List<FrameView> frames = new ArrayList<>();
		for (int t = 0; t < FRAMES; t++)
			frames.add(frame(t, angle, random));
		final double[] sure = new double[FRAMES];
		Arrays.fill(sure, Double.POSITIVE_INFINITY);
		return new TailExchanges(new SceneLine(LINE, frames, NOISE), SceneWeights.DEFAULT,
			Workers.HERE, Progress.NONE)
			.checked(List.of(new Settled(a, sure, 0.1), new Settled(b, sure, 0.1)));
	}

	private static void assertStraight(final List<Settled> filaments) {
		for (int t = 0; t < FRAMES; t++)
			for (int k = 0; k < 2; k++) {
				final double off = filaments.get(k).chains().get(t)
					.distance(rod(t, k == 0 ? 0.3 : -0.3));
				assertTrue(off < 1, "filament " + k + ", frame " + (t + 1) + ": " + off);
			}
	}

	@Test
	void whatWasExchangedIsMendedByBendingAndMotion() {
		assertStraight(checked(6));
	}

	@Test
	void whatIsRightStaysAndIsNotBeyondDoubt() {
		final List<Settled> right = checked(FRAMES);
		assertStraight(right);
		final double gap = right.get(0).gap()[8];
		assertTrue(gap > 1 && Double.isFinite(gap), "gap " + gap);
		final double wrong = checked(0).get(0).gap()[8];
		assertTrue(wrong < gap, "exchanged from the first frame on: gap " + wrong);
	}

	@Test
	void aFrameInWhichNoExchangeFitsIsAsItsNeighboursSay() {
		final List<Chain> a = new ArrayList<>(), b = new ArrayList<>();
		for (int t = 0; t < FRAMES; t++) {
			a.add(t < 6 ? rod(t, ANGLE).slid(t == 2 ? 8 : 0) : exchanged(t, ANGLE, -ANGLE));
			b.add(t < 6 ? rod(t, -ANGLE) : exchanged(t, -ANGLE, ANGLE));
		}
		assertStraight(checked(ANGLE, a, b));
	}

	@Test
	void tailsThatLieBetweenBothAreGivenBackThoughTheyAreNearerThanALineIsWide() {
		final double angle = 0.15;
		final List<Chain> a = new ArrayList<>(), b = new ArrayList<>();
		for (int t = 0; t < FRAMES; t++) {
			a.add(t < 6 || t > 8 ? rod(t, angle) : exchanged(t, angle, 0));
			b.add(t < 6 || t > 8 ? rod(t, -angle) : exchanged(t, -angle, 0));
		}
		final List<Settled> found = checked(angle, a, b);
		for (int t = 6; t <= 8; t++)
			for (int k = 0; k < 2; k++) {
				final Chain right = rod(t, k == 0 ? angle : -angle);
				final double off = found.get(k).chains().get(t).farthest(right);
				assertTrue(off < 1.5, "filament " + k + ", frame " + (t + 1) + ": " + off);
			}
	}
}
