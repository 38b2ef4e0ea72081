
package io.github.knotresolver.track;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

import org.junit.jupiter.api.Test;

import io.github.knotresolver.fit.FilamentEstimate;
import io.github.knotresolver.fit.LineModel;
import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.model.FrameStatus;
import io.github.knotresolver.model.Observation;

class GuessedLengthTest {

	private static final LineModel EVEN = LineModel.uniform(LineModel.Kind.ADDITIVE, 1.2, 1);

	private static final LineModel UNEVEN = new LineModel(LineModel.Kind.ADDITIVE, 1.2, 1,
		new double[]{1, 1, 0.6, 0.4});

	@Test
	void anUnevenFilamentThatAlwaysLiesOnItselfHasAGuessedLength() {
		final List<Observation> frames = frames(20, 0);
		frames.set(4, Observation.without(5, FrameStatus.LOST, "Nothing."));
		frames.set(7, new Observation(8, FrameStatus.CORRECTED, "Given by the user.",
			frames.get(7).contour(), 0, 1, 0, 1));
		final List<Observation> doubted = GuessedLength.doubted(frames, estimate(UNEVEN, false));
		for (int t = 0; t < 20; t++) {
			assertEquals(frames.get(t).contour(), doubted.get(t).contour());
			assertEquals(t == 4 ? Double.NaN : t == 7 ? 1 : 0.5, doubted.get(t).confidence(),
				"frame " + (t + 1));
		}
		assertTrue(doubted.get(0).reason().contains("length is a guess"));
	}

	@Test
	void anEvenFilamentOrOneThatIsSeenToItsTipHasNone() {
		assertEquals(frames(20, 0), GuessedLength.doubted(frames(20, 0), estimate(EVEN, false)));
		assertEquals(frames(12, 8), GuessedLength.doubted(frames(12, 8), estimate(UNEVEN, false)));
		assertTrue(GuessedLength.doubted(List.of(), estimate(UNEVEN, false)).isEmpty());
	}

	@Test
	void whereTheLightDoesNotSayWhereItEndsItHasOneToo() {
		for (final Observation o : GuessedLength.doubted(frames(3, 9), estimate(EVEN, true))) {
			assertEquals(0.5, o.confidence());
			assertTrue(o.reason().contains("where the filament ends"));
		}
	}

	private static FilamentEstimate estimate(final LineModel model, final boolean guessed) {
		return new FilamentEstimate(model, 1, 100, 0.1, new Point(30, 30), guessed);
	}

	/** Rings of one and a half turns, then arcs of half a turn. */
	private static List<Observation> frames(final int rings, final int arcs) {
		final List<Observation> frames = new ArrayList<>();
		for (int t = 0; t < rings + arcs; t++)
			frames.add(new Observation(t + 1, FrameStatus.RESOLVED, "",
				Optional.of(arc(t < rings ? 3 * Math.PI : Math.PI)), 0, 1, 0, 0.99));
		return frames;
	}

	private static Polyline arc(final double turn) {
		final double[] x = new double[91], y = new double[91];
		for (int i = 0; i <= 90; i++) {
			x[i] = 30 + 15 * Math.cos(turn * i / 90);
			y[i] = 30 + 15 * Math.sin(turn * i / 90);
		}
		return Polyline.of(x, y);
	}
}
