package io.github.knotresolver.session;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

import org.junit.jupiter.api.Test;

import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.model.Anchor;
import io.github.knotresolver.model.Constraint;
import io.github.knotresolver.model.Constraint.Kind;
import io.github.knotresolver.model.FilamentTrack;
import io.github.knotresolver.model.FrameStatus;
import io.github.knotresolver.model.Observation;
import io.github.knotresolver.model.UserException;

/** Filaments that a person exchanges from a frame on. */
class ExchangesTest {

	private static final int FRAMES = 6;

	/** Filament 1 lies at y = 10, 2 at y = 20, 3 at y = 30; they glide to the right. */
	private static final List<FilamentTrack> TRACKS = List.of(track(1, Anchor.FREE, 40),
		track(2, Anchor.FREE, 46), track(3, Anchor.CLAMPED, 50));

	private static FilamentTrack track(final int id, final Anchor anchor, final double length) {
		final List<Observation> frames = new ArrayList<>();
		for (int t = 1; t <= FRAMES; t++)
			frames.add(new Observation(t, FrameStatus.RESOLVED, "",
				Optional.of(line(id, t, length)), 0, 1, 0, 0.9));
		return new FilamentTrack(id, anchor, Optional.empty(), length, 1, frames);
	}

	private static Polyline line(final int id, final int t, final double length) {
		return Polyline.of(List.of(new Point(t, 10 * id), new Point(t + length, 10 * id)));
	}

	private static Constraint swap(final int filament, final int frame, final int other) {
		return new Constraint(filament, frame, Kind.SWAP,
			Polyline.of(List.of(new Point(20, 10 * filament), new Point(20, 10 * other + 1))));
	}

	private static List<Double> rows(final FilamentTrack track) {
		return track.frames().stream().map(o -> o.contour().orElseThrow().first().y()).toList();
	}

	@Test
	void fromThatFrameOnEachIsTheOther() {
		final List<FilamentTrack> now = Exchanges.in(TRACKS, List.of(swap(1, 4, 2)));
		assertEquals(List.of(10.0, 10.0, 10.0, 20.0, 20.0, 20.0), rows(now.get(0)));
		assertEquals(List.of(20.0, 20.0, 20.0, 10.0, 10.0, 10.0), rows(now.get(1)));
		assertEquals(TRACKS.get(2), now.get(2));
		assertEquals(43, now.get(0).length(), 1e-9);
		assertEquals(List.of(1, 2, 3), now.stream().map(FilamentTrack::id).toList());
	}

	@Test
	void aSecondExchangeIsOfWhatTheFirstMade() {
		assertEquals(List.of(10.0, 20.0, 20.0, 20.0, 10.0, 10.0),
			rows(Exchanges.in(TRACKS, List.of(swap(1, 2, 2), swap(2, 5, 2))).get(0)));
	}

	@Test
	void thePartsThatAreJoinedRunTheSameWay() {
		final FilamentTrack against = new FilamentTrack(2, Anchor.FREE, Optional.empty(), 46, 1,
			TRACKS.get(1).frames().stream()
				.map(o -> o.withContour(o.contour().orElseThrow().reversed())).toList());
		final List<FilamentTrack> now = Exchanges.in(List.of(TRACKS.get(0), against),
			List.of(swap(1, 5, 2)));
		// Of the first one more is left than is joined to it, and so the rest is turned round.
		assertTrue(now.get(0).frames().stream().map(o -> o.contour().orElseThrow())
			.allMatch(c -> c.first().x() < c.last().x()));
		assertTrue(now.get(1).frames().stream().map(o -> o.contour().orElseThrow())
			.allMatch(c -> c.first().x() > c.last().x()));
	}

	@Test
	void whatCannotBeExchangedIsRefusedInOneSentence() {
		refused(swap(1, 4, 3), "Filament 3 is held at its first end");
		refused(swap(1, 4, 8), "no other filament does within 4 px");
		refused(swap(1, 4, 1), "no other filament does within 4 px");
	}

	private static void refused(final Constraint word, final String sentence) {
		final String message = assertThrows(UserException.class,
			() -> Exchanges.in(TRACKS, List.of(word))).getMessage();
		assertTrue(message.contains(sentence), message);
	}
}
