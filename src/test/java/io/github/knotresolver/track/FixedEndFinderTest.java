package io.github.knotresolver.track;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import io.github.knotresolver.Drawn;
import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.progress.Progress;

class FixedEndFinderTest {

	private static final Point CLAMP = new Point(15, 55);

	/** A filament that swings about its clamp, its stem at rest for 30 px. */
	private static Polyline filament(final double x, final double y, final double swing) {
		final double[] xy = new double[2 * 16];
		xy[0] = x;
		xy[1] = y;
		for (int i = 1; i < 16; i++) {
			xy[2 * i] = 15 + 6 * i;
			xy[2 * i + 1] = 55 + Math.max(0, i - 5) * swing;
		}
		return Drawn.line(xy);
	}

	private static Point found(final List<FrameView> frames) {
		return new FixedEndFinder(frames, Progress.NONE).find().orElseThrow();
	}

	@Test
	void theEndThatStaysIsFound() {
		final List<FrameView> frames = new ArrayList<>();
		for (int t = 0; t < 12; t++)
			frames.add(DrawnFrames.lines(t + 1, filament(15, 55, 4 * Math.sin(0.9 * t))));
		assertTrue(found(frames).distanceTo(CLAMP) < 5, found(frames).toString());
	}

	/**
	 * Debris sticks to the stem: its end stays just as well, and stiller than the clamp, so
	 * that it has the votes. But from there, trails leave the stem out.
	 */
	@ParameterizedTest
	@ValueSource(longs = {1, 2, 3, 4, 5, 6})
	void debrisThatHasTheVotesIsNotTheFixedEnd(final long seed) {
		final Random random = new Random(seed);
		final List<FrameView> frames = new ArrayList<>();
		for (int t = 0; t < 12; t++)
			frames.add(DrawnFrames.lines(t + 1,
				filament(14 + random.nextInt(3), 54 + random.nextInt(3), 4 * Math.sin(0.9 * t)),
				Drawn.line(39, 55, 39, 45)));
		final Point found = found(frames);
		assertTrue(found.distanceTo(CLAMP) < 6, "seed " + seed + ": " + found);
	}

	@Test
	void objectsThatRestHaveNoSay() {
		final List<FrameView> frames = new ArrayList<>();
		for (int t = 0; t < 12; t++)
			frames.add(DrawnFrames.lines(t + 1, filament(15, 55, 4 * Math.sin(0.9 * t)),
				Drawn.line(10, 5, 120, 5), Drawn.line(100, 12, 104, 12)));
		assertTrue(found(frames).distanceTo(CLAMP) < 5, found(frames).toString());
	}

	@Test
	void withoutAFilamentThereIsNone() {
		assertEquals(true,
			new FixedEndFinder(List.of(DrawnFrames.lines(1), DrawnFrames.lines(2)), Progress.NONE)
				.find().isEmpty());
	}
}
