package io.github.knotresolver.session;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

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
}
