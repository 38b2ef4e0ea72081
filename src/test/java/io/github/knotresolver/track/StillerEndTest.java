
package io.github.knotresolver.track;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.IntFunction;

import org.junit.jupiter.api.Test;

import io.github.knotresolver.Drawn;
import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.model.FrameStatus;
import io.github.knotresolver.model.Observation;

class StillerEndTest {

	private static Optional<Point> stiller(final IntFunction<Polyline> contours) {
		final List<FrameView> frames = new ArrayList<>();
		final List<Observation> found = new ArrayList<>();
		for (int t = 0; t < 20; t++) {
			final Polyline contour = contours.apply(t);
			frames.add(DrawnFrames.lines(t + 1, contour));
			found.add(
				new Observation(t + 1, FrameStatus.RESOLVED, "", Optional.of(contour), 0, 1, 0, 1));
		}
		return StillerEnd.of(frames, found);
	}

	@Test
	void aTipThatStaysWhileTheOtherEndMovesIsTheFixedEnd() {
		final Point end = stiller(
			t -> Drawn.line(100 - 0.3 * t, 50, 60, 40 + t, 20, 50 + 0.05 * (t % 2))).orElseThrow();
		assertEquals(0, end.distanceTo(new Point(20, 50)), 0.1);
	}

	/** Around a fixed end that lies close to another strand, contours end within a few pixels. */
	@Test
	void aTipThatWandersByLittleWhileTheOtherEndIsDrawnInIsTheFixedEnd() {
		assertTrue(stiller(t -> Drawn.line(105 - 1.5 * t, 50, 60, 40 + t, 20 + 0.2 * t, 50 + t % 3))
			.isPresent());
	}

	@Test
	void anEndThatStaysIsTheFixedEndWhateverTheTipDoes() {
		assertTrue(
			stiller(t -> Drawn.line(20, 50 + 0.05 * (t % 2), 60, 40 + t, 100, 50)).isEmpty());
		assertTrue(stiller(t -> Drawn.line(20, 50, 60, 40 + t, 100 - t, 50)).isEmpty());
	}

	@Test
	void whereAFilamentLeavesThePictureIsNoEnd() {
		assertTrue(stiller(t -> Drawn.line(20 + 0.5 * t, 50, 60, 40 + t, 129, 50)).isEmpty());
	}

	@Test
	void onADriftingStageBothEndsMove() {
		assertTrue(
			stiller(t -> Drawn.line(20 + 0.5 * t, 50, 60 + 0.5 * t, 40 + t, 100 + 0.6 * t, 50))
				.isEmpty());
	}

	/** In a few frames both ends may move alike: then it is not known which one is held. */
	@Test
	void whereTheFixedEndMovesLikeTheOtherNoContourIsBelieved() {
		final List<Observation> restless = found(
			t -> Drawn.line(100 - 1.6 * t, 50, 60, 40, 20 + t, 50));
		for (final Observation o : StillerEnd.doubted(restless)) {
			assertEquals(0.5, o.confidence());
			assertTrue(o.reason().contains("which one it is is a guess"));
		}
		final List<Observation> held = found(
			t -> Drawn.line(20, 50 + 0.05 * (t % 2), 60, 40 + t, 100 - t, 50)),
			jittering = found(t -> Drawn.line(20 + t % 2, 50, 60, 40, 100 - 2 * t, 50)),
			still = found(t -> Drawn.line(20 + 0.2 * (t % 2), 50, 60, 40, 100, 50));
		assertEquals(held, StillerEnd.doubted(held));
		assertEquals(jittering, StillerEnd.doubted(jittering));
		assertEquals(still, StillerEnd.doubted(still));
		assertTrue(StillerEnd.doubted(List.of()).isEmpty());
	}

	private static List<Observation> found(final IntFunction<Polyline> contours) {
		final List<Observation> found = new ArrayList<>();
		for (int t = 0; t < 4; t++)
			found.add(new Observation(t + 1, FrameStatus.RESOLVED, "",
				Optional.of(contours.apply(t)), 0, 1, 0, 1));
		return found;
	}
}
