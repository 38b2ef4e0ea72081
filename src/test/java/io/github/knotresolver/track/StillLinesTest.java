package io.github.knotresolver.track;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.Set;
import java.util.function.IntFunction;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import io.github.knotresolver.fit.Chain;
import io.github.knotresolver.fit.LineModel;
import io.github.knotresolver.fit.LineModel.Kind;
import io.github.knotresolver.fit.LineTables;
import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.progress.Progress;
import io.github.knotresolver.progress.Workers;

class StillLinesTest {

	private static final int SIZE = 120, FRAMES = 20;
	private static final double NOISE = 0.05, STRAND = 80;
	private static final LineTables LOOK = LineTables
		.together(LineModel.uniform(Kind.ADDITIVE, 1.4, 1));

	/** Lines of which each is so many strands bright. */
	private static FrameView frame(final int t, final Kind kind, final List<Chain> chains,
		final double[] brightness, final Random random) {
		final double[] light = new double[SIZE * SIZE];
		for (int k = 0; k < chains.size(); k++) {
			final double[] drawn = DrawnFrames.light(SIZE, LOOK, List.of(chains.get(k)));
			for (int i = 0; i < light.length; i++)
				light[i] = kind == Kind.ADDITIVE
					? light[i] + brightness[k] * drawn[i]
					: Math.max(light[i], brightness[k] * drawn[i]);
		}
		return DrawnFrames.lit(t + 1, light, NOISE, random).scaled(1 / STRAND);
	}

	private static List<FrameView> movie(final Kind kind, final IntFunction<List<Chain>> chains,
		final double... brightness) {
		final Random random = new Random(5);
		final List<FrameView> frames = new ArrayList<>();
		for (int t = 0; t < FRAMES; t++)
			frames.add(frame(t, kind, chains.apply(t), brightness, random));
		return frames;
	}

	private static StillLines.Found found(final List<FrameView> frames, final Point... meant) {
		return StillLines.in(frames, Set.of(Kind.ADDITIVE, Kind.SATURATING), List.of(meant),
			Workers.HERE, Progress.NONE);
	}

	private static void assertNone(final List<FrameView> frames, final Point... meant) {
		final StillLines.Found found = found(frames, meant);
		assertEquals(List.of(), found.lines());
		assertSame(frames, found.rest());
	}

	private static Chain rod(final double x, final double y, final double angle,
		final double length) {
		return Chain.inScene(Polyline.of(new double[]{x, x + length * Math.cos(angle)},
			new double[]{y, y + length * Math.sin(angle)}), length);
	}

	private static final Chain LINE = rod(15, 30, 0.3, 90);

	/** A bent filament whose first point stays; it swings over the line. */
	private static Chain beating(final int t, final double swing) {
		final double[] x = new double[80], y = new double[80];
		x[0] = 25;
		y[0] = 100;
		for (int i = 1; i < x.length; i++) {
			final double angle = -0.8 + swing * Math.sin(0.5 * t + i * 0.04);
			x[i] = x[i - 1] + Math.cos(angle);
			y[i] = y[i - 1] + Math.sin(angle);
		}
		return Chain.inScene(Polyline.of(x, y), 79);
	}

	@ParameterizedTest
	@ValueSource(doubles = {0.6, 2})
	void aLineThatLiesStillIsTakenOffHoweverBright(final double brightness) {
		final List<FrameView> with = movie(Kind.ADDITIVE, t -> List.of(beating(t, 0.5), LINE), 1,
			brightness);
		final StillLines.Found found = found(with);
		assertEquals(1, found.lines().size());
		final SceneTracks.Filament line = found.lines().get(0);
		assertEquals(90, line.length(), 0.5);
		for (int t = 0; t < FRAMES; t++) {
			assertTrue(line.frames().get(t).confidence() > 0.95, "frame " + (t + 1));
			assertTrue(SceneSeed.oneWay(line.frames().get(t).contour().orElseThrow(),
				LINE.polyline()) < 0.2);
			final double[] left = found.rest().get(t).light().pixels(),
				alone = DrawnFrames.light(SIZE, LOOK, List.of(beating(t, 0.5)));
			for (int i = 0; i < left.length; i++)
				assertEquals(STRAND * alone[i], left[i], STRAND * 0.35, "pixel " + i);
			assertTrue(SingleFilament.isOneObject(List.of(found.rest().get(t))),
				"frame " + (t + 1));
		}
		assertTrue(SingleFilament.isClampedAlone(found.rest()));
	}

	@Test
	void aFilamentThatRunsIntoALineAndOutOfItIsLeftAsItWas() {
		final IntFunction<Chain> along = t -> Chain.inScene(
			Polyline.of(new double[]{20, 45, 60, 80 - t}, new double[]{70, 49, 42, 43}), 66 - t);
		final StillLines.Found found = found(
			movie(Kind.ADDITIVE, t -> List.of(rod(10, 30, 0.25, 100), along.apply(t)), 1, 1));
		assertEquals(1, found.lines().size());
		for (int t = 0; t < FRAMES; t++)
			assertTrue(
				SceneSeed.oneWay(found.lines().get(0).frames().get(t).contour().orElseThrow(),
					rod(10, 30, 0.25, 100).polyline()) < 0.5);
	}

	/** Its clamp lies in a ring that hardly moves, which bulges over the line. */
	private static Chain ringed(final int t) {
		final double[] x = new double[130], y = new double[130];
		x[0] = 50;
		y[0] = 46;
		for (int i = 1; i < x.length; i++) {
			final double angle = i < 85
				? 0.4 + i / 13.
				: 0.4 + 85 / 13. + 0.02 * (i - 85) * Math.sin(0.6 * t);
			x[i] = x[i - 1] + Math.cos(angle);
			y[i] = y[i - 1] + Math.sin(angle);
		}
		return Chain.inScene(Polyline.of(x, y), 129);
	}

	@Test
	void aLineGoesStraightOnThroughARingThatHardlyMoves() {
		final Chain line = rod(10, 50, 0.05, 100);
		final StillLines.Found found = found(
			movie(Kind.ADDITIVE, t -> List.of(ringed(t), line), 1, 1));
		assertEquals(1, found.lines().size());
		assertTrue(SceneSeed.oneWay(found.lines().get(0).frames().get(0).contour().orElseThrow(),
			line.polyline()) < 0.5);
	}

	@Test
	void whereLightDoesNotAddUpNothingIsTakenOff() {
		assertNone(movie(Kind.SATURATING, t -> List.of(beating(t, 0.5), LINE), 1, 1));
	}

	@Test
	void aPartOfAFilamentThatLiesStillIsNoLine() {
		assertNone(movie(Kind.ADDITIVE, t -> List.of(beating(t, 0.5)), 1));
		// Two that are held at one end, and cross near there.
		assertNone(movie(Kind.ADDITIVE,
			t -> List.of(beating(t, 0.3),
				Chain.inScene(Polyline.of(new double[]{20, 60, 80 + 10 * Math.sin(t)},
					new double[]{60, 90, 100 - 10 * Math.cos(t)}), 76)),
			1, 1));
	}

	@Test
	void whatIsMeantAndWhatNothingPassesAreLeftIn() {
		assertNone(movie(Kind.ADDITIVE, t -> List.of(beating(t, 0.5), LINE), 1, 1),
			new Point(17, 31));
		assertNone(movie(Kind.ADDITIVE, t -> List.of(rod(15, 20, 0.1, 90), beating(t, 0.1)), 1, 1));
	}

	@Test
	void aLineThatGoesIsThereAsLongAsItIs() {
		final StillLines.Found found = found(movie(Kind.ADDITIVE,
			t -> t < FRAMES - 1 ? List.of(beating(t, 0.5), LINE) : List.of(beating(t, 0.5)), 1, 1));
		assertEquals(1, found.lines().size());
		for (int t = 0; t < FRAMES; t++)
			assertEquals(t < FRAMES - 1, found.lines().get(0).frames().get(t).contour().isPresent(),
				"frame " + (t + 1));
		assertTrue(SingleFilament.isClampedAlone(found.rest()));
	}
}
