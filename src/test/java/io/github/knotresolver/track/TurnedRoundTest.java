package io.github.knotresolver.track;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

import org.junit.jupiter.api.Test;

import io.github.knotresolver.Drawn;
import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.model.FrameStatus;
import io.github.knotresolver.model.Observation;

class TurnedRoundTest {

	private static final int FRAMES = 20;

	@Test
	void framesThatRunFromTheOtherEndAreDoubted() {
		final List<Observation> frames = beating();
		for (int t = 13; t < FRAMES; t++)
			frames.set(t, frames.get(t).withContour(frames.get(t).contour().get().reversed()));
		final List<Observation> doubted = TurnedRound.doubted(frames);
		for (int t = 0; t < FRAMES; t++) {
			assertEquals(t < 12 ? 0.99 : 0.5, doubted.get(t).confidence(), "frame " + t);
			assertEquals(frames.get(t).contour(), doubted.get(t).contour());
			assertEquals(t >= 12, doubted.get(t).reason().contains("ends may be exchanged"));
		}
	}

	@Test
	void theFewAreDoubtedAlsoAtTheBeginning() {
		final List<Observation> frames = beating();
		for (int t = 0; t < 5; t++)
			frames.set(t, frames.get(t).withContour(frames.get(t).contour().get().reversed()));
		frames.set(2, Observation.without(3, FrameStatus.LOST, "Nothing."));
		final List<Observation> doubted = TurnedRound.doubted(frames);
		for (int t = 0; t < FRAMES; t++)
			assertEquals(t == 2 ? Double.NaN : t < 6 ? 0.5 : 0.99, doubted.get(t).confidence(),
				"frame " + t);
	}

	@Test
	void whatBeatsOrWasSaidStaysAsItIs() {
		final List<Observation> frames = beating();
		assertEquals(frames, TurnedRound.doubted(frames));
		final Observation said = frames.get(13);
		frames.set(13, new Observation(14, FrameStatus.CORRECTED, "Given by the user.",
			Optional.of(said.contour().get().reversed()), 0, 1, 0, 1));
		assertEquals(1, TurnedRound.doubted(frames).get(13).confidence());
		assertTrue(TurnedRound.doubted(List.of()).isEmpty());
	}

	/** A clamped arc whose tip swings by its whole length. */
	private static List<Observation> beating() {
		final List<Observation> frames = new ArrayList<>();
		for (int t = 0; t < FRAMES; t++)
			frames.add(new Observation(t + 1, FrameStatus.RESOLVED, "",
				Optional.of(Drawn.arc(new Point(0, 0), 0.03 * Math.sin(0.7 * t))), 0, 1, 0, 0.99));
		return frames;
	}
}
