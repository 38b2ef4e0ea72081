package io.github.knotresolver.model;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;

import java.util.List;
import java.util.Optional;

import org.junit.jupiter.api.Test;

import io.github.knotresolver.geometry.Polyline;

/** A doubt lowers a confidence, never raises it, and what the user said stays. */
class ObservationTest {

	private static final String BEFORE = "Seen before.", WHY = "Doubtful: a test.";

	@Test
	void doubtLowersTheConfidenceAndSaysWhy() {
		final Observation sure = observed(FrameStatus.RESOLVED, "", 0.99);
		final Observation doubted = sure.doubted(0.5, WHY);
		assertEquals(List.of(0.5, WHY), List.of(doubted.confidence(), doubted.reason()));
		final Observation limited = sure.atMost(0.5, WHY);
		assertEquals(List.of(0.5, WHY), List.of(limited.confidence(), limited.reason()));
		assertEquals("", sure.atMost(0.95, WHY).reason());
	}

	@Test
	void earlierReasonStaysOnlyUnderALimit() {
		final Observation likely = observed(FrameStatus.RESOLVED, BEFORE, 0.8);
		assertEquals(BEFORE, likely.atMost(0.5, WHY).reason());
		assertEquals(WHY, likely.doubted(0.5, WHY).reason());
	}

	@Test
	void whatTheUserSaidIsLessSureOrHasNoContourStays() {
		for (final Observation o : List.of(observed(FrameStatus.CORRECTED, Observation.GIVEN, 1),
			observed(FrameStatus.RESOLVED, BEFORE, 0.5),
			Observation.without(3, FrameStatus.LOST, Observation.NOT_FOUND))) {
			assertSame(o, o.atMost(0.5, WHY));
			assertSame(o, o.doubted(0.5, WHY));
		}
	}

	private static Observation observed(final FrameStatus status, final String reason,
		final double confidence) {
		return new Observation(3, status, reason,
			Optional.of(Polyline.of(new double[]{0, 10}, new double[]{0, 0})), 0, 1, 0, confidence);
	}
}
