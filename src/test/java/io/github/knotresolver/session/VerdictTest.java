package io.github.knotresolver.session;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.IntToDoubleFunction;
import java.util.stream.IntStream;

import org.junit.jupiter.api.Test;

import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.model.Anchor;
import io.github.knotresolver.model.FilamentTrack;
import io.github.knotresolver.model.FrameStatus;
import io.github.knotresolver.model.Observation;

class VerdictTest {

	/** A straight filament that moves by so many pixels a frame. */
	private static FilamentTrack track(final double step, final IntToDoubleFunction confidence) {
		final List<Observation> frames = IntStream.range(0, 12)
			.mapToObj(t -> new Observation(t + 1, FrameStatus.RESOLVED, "",
				Optional.of(Polyline.of(new double[]{0, 20, 40},
					new double[]{step * t, step * t, step * t})),
				0, 1, 0, confidence.applyAsDouble(t)))
			.toList();
		return new FilamentTrack(1, Anchor.CLAMPED, Optional.empty(), 40, 0.1, frames);
	}

	private static List<String> on(final FilamentTrack... tracks) {
		return Verdict.on(List.of(tracks));
	}

	@Test
	void ofAGoodResultThereIsNothingToSay() {
		assertEquals(List.of(), on(track(1, t -> 0.99)));
		assertEquals(List.of(), on(track(1, t -> t < 5 ? 0.99 : 0.1)));
	}

	@Test
	void aResultOfWhichMostIsDoubtfulIsMarkedAsAWhole() {
		final List<String> verdict = on(track(1, t -> t < 3 ? 0.99 : 0.1));
		assertEquals(1, verdict.size());
		assertTrue(verdict.get(0).startsWith("Doubtful as a whole: only 3 of 12 contours"),
			verdict.get(0));
	}

	@Test
	void aMovieInWhichNothingMovesIsMarked() {
		final FilamentTrack still = track(0.01, t -> 0.99), moving = track(1, t -> 0.99);
		assertTrue(on(still).get(0).startsWith("Nothing moves: the contour is"),
			on(still).toString());
		assertEquals(List.of(), on(still, moving));
	}

	@Test
	void noContourIsSureWhereTheFilamentIsInDoubtInMostFrames() {
		final List<Observation> doubtful = Verdict
			.doubted(track(1, t -> t < 6 ? 0.99 : 0.1).frames());
		assertEquals(1.5 * 6 / 12, doubtful.get(0).confidence());
		assertTrue(doubtful.get(0).reason().contains("other frames"), doubtful.get(0).reason());
		assertEquals(0.1, doubtful.get(6).confidence());
		assertEquals("", doubtful.get(6).reason());
		assertEquals(0.5,
			Verdict.doubted(track(1, t -> t < 1 ? 0.99 : 0.1).frames()).get(0).confidence());
		final List<Observation> mostlySure = track(1, t -> t < 8 ? 0.99 : 0.1).frames();
		assertEquals(mostlySure, Verdict.doubted(mostlySure));
	}

	@Test
	void noContourIsSureBetweenTwoThatAreInDoubt() {
		final double[] confidence = {0.99, 0.99, 0.7, 0.98, 0.6, 0.99, 0.99, 0.99, 0.3, 0.97, 0.2,
			0.99};
		final List<Observation> given = track(1, t -> confidence[t]).frames();
		final List<Observation> doubted = Verdict.doubted(given);
		assertEquals(0.7, doubted.get(3).confidence());
		assertTrue(doubted.get(3).reason().contains("before and after"), doubted.get(3).reason());
		assertEquals(0.5, doubted.get(9).confidence());
		for (final int same : new int[]{0, 1, 2, 4, 5, 6, 7, 8, 10, 11})
			assertEquals(given.get(same), doubted.get(same));
	}

	@Test
	void fewFramesSayNothingAboutEachOther() {
		final List<Observation> few = track(1, t -> t < 1 ? 0.99 : 0.1).frames().subList(0, 4);
		assertEquals(few, Verdict.doubted(few));
	}

	@Test
	void whatTheUserSaidIsNotDoubted() {
		final List<Observation> frames = new ArrayList<>(track(1, t -> 0.1).frames());
		final Observation first = frames.get(0);
		frames.set(0, new Observation(1, FrameStatus.CORRECTED, Observation.GIVEN, first.contour(),
			0, 1, 0, 1));
		assertEquals(frames, Verdict.doubted(frames));
	}
}
