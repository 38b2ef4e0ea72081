
package io.github.knotresolver.track;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Collections;
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
		final List<Observation> doubted = GuessedLength.doubted(frames, estimate(UNEVEN, false),
			false);
		for (int t = 0; t < 20; t++) {
			assertEquals(frames.get(t).contour(), doubted.get(t).contour());
			assertEquals(t == 4 ? Double.NaN : t == 7 ? 1 : 0.5, doubted.get(t).confidence(),
				"frame " + (t + 1));
		}
		assertTrue(doubted.get(0).reason().contains("length is a guess"));
	}

	@Test
	void anEvenFilamentOrOneThatIsSeenToItsTipHasNone() {
		assertEquals(frames(20, 0),
			GuessedLength.doubted(frames(20, 0), estimate(EVEN, false), false));
		assertEquals(frames(12, 8),
			GuessedLength.doubted(frames(12, 8), estimate(UNEVEN, false), false));
		assertTrue(GuessedLength.doubted(List.of(), estimate(UNEVEN, false), false).isEmpty());
	}

	@Test
	void aFewFramesInWhichAnEvenFilamentLiesOnItselfDoNotTellItsLengthEither() {
		assertGuessed("the movie is short",
			GuessedLength.doubted(frames(9, 0), estimate(EVEN, false), false));
		assertEquals(frames(10, 0),
			GuessedLength.doubted(frames(10, 0), estimate(EVEN, false), false));
		assertEquals(frames(6, 3),
			GuessedLength.doubted(frames(6, 3), estimate(EVEN, false), false));
	}

	@Test
	void aClippedFilamentThatAlwaysLiesOnItselfHasOne() {
		assertGuessed("clipped", GuessedLength.doubted(frames(20, 0), estimate(EVEN, false), true));
		assertEquals(frames(12, 8),
			GuessedLength.doubted(frames(12, 8), estimate(EVEN, false), true));
	}

	@Test
	void whereTheLightDoesNotSayWhereItEndsItHasOneToo() {
		assertGuessed("where the filament ends",
			GuessedLength.doubted(frames(3, 9), estimate(EVEN, true), false));
	}

	/** A tip that comes to lie on the filament, and one that breaks off while it does. */
	@Test
	void aBreakAfterWhichNoFrameShowsTheEndIsAGuess() {
		final List<Observation> arcsFirst = new ArrayList<>(frames(12, 8));
		Collections.reverse(arcsFirst);
		final List<Observation> doubted = GuessedLength.doubtedAtBreak(arcsFirst, brokenAt(8, 20),
			EVEN);
		for (int t = 0; t < 20; t++)
			assertEquals(t < 8 ? 0.99 : 0.5, doubted.get(t).confidence(), "frame " + t);
		assertTrue(doubted.get(8).reason().contains("no frame shows its end"));
		final List<Observation> before = GuessedLength.doubtedAtBreak(frames(12, 8),
			brokenAt(12, 20), EVEN);
		for (int t = 0; t < 20; t++)
			assertEquals(t < 12 ? 0.5 : 0.99, before.get(t).confidence(), "frame " + t);
	}

	@Test
	void aBreakThatIsShownOnBothSidesIsBelieved() {
		assertEquals(frames(0, 20),
			GuessedLength.doubtedAtBreak(frames(0, 20), brokenAt(8, 20), EVEN));
		final List<Observation> shownTwice = new ArrayList<>(frames(6, 2));
		shownTwice.addAll(frames(8, 2));
		assertEquals(shownTwice, GuessedLength.doubtedAtBreak(shownTwice, brokenAt(8, 18), EVEN));
		final List<Observation> wound = frames(20, 0);
		assertEquals(wound,
			GuessedLength.doubtedAtBreak(wound, LengthCourse.constant(100, 20), EVEN));
	}

	private static void assertGuessed(final String why, final List<Observation> doubted) {
		for (final Observation o : doubted) {
			assertEquals(0.5, o.confidence());
			assertTrue(o.reason().contains(why));
		}
	}

	private static LengthCourse brokenAt(final int at, final int frames) {
		final double[] lengths = new double[frames], others = new double[frames];
		for (int t = 0; t < frames; t++) {
			lengths[t] = t < at ? 100 : 90;
			others[t] = Double.NaN;
		}
		return new LengthCourse(lengths, others, LengthCourse.Kind.BROKEN, at);
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
