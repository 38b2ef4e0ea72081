package io.github.knotresolver.track;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Optional;
import java.util.function.IntFunction;
import java.util.stream.IntStream;

import org.junit.jupiter.api.Test;

import io.github.knotresolver.fit.Chain;
import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.track.OpenFrames.Seen;

/** Whether a fixed end stays is told by where it is seen in open frames. */
class AnchorPathTest {

	private static final int FRAMES = 60;

	@Test
	void whatIsRoundedToPixelsStays() {
		// A place between two pixels, drawn on the one or the other.
		assertEquals(0, settled(30, t -> new Point(t % 7 < 3 ? 19.1 : 20.9, 10)).range());
	}

	@Test
	void aSlowDriftIsFollowedAlsoIfFewFramesAreOpen() {
		final AnchorPath path = settled(17,
			t -> new Point(20 + 0.1 * t + 0.1 * (t % 2), 10 - 0.1 * t));
		assertTrue(path.range() > 1.5, path.range() + " px");
		assertEquals(21.05, path.at(10).x(), 0.3);
	}

	@Test
	void aWrongFrameMovesNothing() {
		assertEquals(0, settled(20, t -> new Point(t == 5 ? 40 : 20 + 0.1 * (t % 3), 10)).range());
	}

	@Test
	void jitterIsFollowed() {
		final AnchorPath path = settled(60,
			t -> new Point(20 + (t % 2 == 0 ? 1.5 : -1.5), t % 3 == 0 ? 9 : 11));
		assertTrue(path.at(10).x() > 21 && path.at(11).x() < 19, path.places().toString());
	}

	/** Contours that are not held, in a movie whose stage drifts. */
	private static AnchorPath refined(final IntFunction<Point> end) {
		return AnchorPath.still(new Point(20, 10), FRAMES).refined(
			IntStream.range(0, FRAMES).mapToObj(t -> Optional.of(from(end.apply(t)))).toList());
	}

	@Test
	void contoursThatBeginElsewhereForAFrameOrTwoMoveNothing() {
		final IntFunction<Point> drift = t -> new Point(20 + 0.2 * t, 10 - 0.1 * t);
		final AnchorPath path = refined(t -> t == 20 || t == 21 || t == 40
			? new Point(drift.apply(t).x() - 13, drift.apply(t).y() + 2)
			: drift.apply(t));
		for (int t = 0; t < FRAMES; t++)
			assertTrue(path.at(t).distanceTo(drift.apply(t)) < 0.5,
				"frame " + t + ": " + path.at(t));
	}

	@Test
	void anEndThatJumpsForGoodIsFollowed() {
		final IntFunction<Point> jump = t -> new Point(t < 30 ? 20 + 0.02 * t : 33, 10);
		final AnchorPath path = refined(jump);
		for (int t = 0; t < FRAMES; t++)
			assertTrue(path.at(t).distanceTo(jump.apply(t)) < 0.5,
				"frame " + t + ": " + path.at(t));
	}

	/** The first so many of the frames are open, and the end is seen there. */
	private static AnchorPath settled(final int open, final IntFunction<Point> end) {
		final OpenFrames frames = new OpenFrames(IntStream.range(0, open)
			.mapToObj(t -> new Seen(t, from(end.apply(t)), true, true, false)).toList());
		return AnchorPath.still(new Point(20, 10), FRAMES).settled(frames, new Point(20, 10));
	}

	private static Chain from(final Point end) {
		return Chain.along(
			Polyline.of(new double[]{end.x(), end.x() + 40}, new double[]{end.y(), end.y()}), 20,
			40);
	}
}
