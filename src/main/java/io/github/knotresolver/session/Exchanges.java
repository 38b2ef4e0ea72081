package io.github.knotresolver.session;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;

import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.model.Alternative;
import io.github.knotresolver.model.Anchor;
import io.github.knotresolver.model.Constraint;
import io.github.knotresolver.model.FilamentTrack;
import io.github.knotresolver.model.Observation;
import io.github.knotresolver.model.UserException;

/**
 * Filaments that a person exchanges from a frame on, in the order of the frames. Each keeps its ends:
 * if the joined parts run against each other, the shorter one is turned round.
 */
final class Exchanges {

	private Exchanges() {
	}

	/**
	 * @param tracks the filaments, rising by their numbers
	 * @param said all that a person said, in the order of frames
	 * @return the same, with their parts exchanged
	 * @throws UserException if one cannot be exchanged, in one sentence
	 */
	static List<FilamentTrack> in(final List<FilamentTrack> tracks, final List<Constraint> said) {
		final List<FilamentTrack> now = new ArrayList<>(tracks);
		for (final Constraint c : said)
			if (c.kind() == Constraint.Kind.SWAP) {
				final FilamentTrack one = track(now, c.filament()), other = other(now, c);
				requireFree(one, c.frame());
				requireFree(other, c.frame());
				now.set(now.indexOf(one), joined(one, other, c.frame()));
				now.set(now.indexOf(other), joined(other, one, c.frame()));
			}
		return now;
	}

	private static FilamentTrack track(final List<FilamentTrack> tracks, final int id) {
		return tracks.stream().filter(t -> t.id() == id).findFirst().orElseThrow();
	}

	private static FilamentTrack other(final List<FilamentTrack> tracks, final Constraint c) {
		final Point place = c.shape().last();
		return tracks.stream().filter(t -> t.id() != c.filament())
			.filter(t -> distance(t, c.frame(), place) <= SessionTuning.SHOWN_EXCHANGE)
			.min(Comparator.comparingDouble(t -> distance(t, c.frame(), place)))
			.orElseThrow(() -> new UserException("corrections exchange filament " + c.filament()
				+ " from frame " + c.frame() + " on with the one that passes " + place
				+ ", but there no other filament does within "
				+ Math.round(SessionTuning.SHOWN_EXCHANGE)
				+ " px; name a place on the contour of the other one."));
	}

	private static double distance(final FilamentTrack track, final int frame, final Point place) {
		return track.frames().get(frame - 1).contour().map(c -> c.distanceTo(place))
			.orElse(Double.POSITIVE_INFINITY);
	}

	private static void requireFree(final FilamentTrack track, final int frame) {
		if (track.anchor() == Anchor.CLAMPED)
			throw new UserException(
				"Filament " + track.id() + " is held at its first end, which stays"
					+ " where it is, so it cannot be exchanged from frame " + frame
					+ " on; draw the contours of the frames that are wrong.");
	}

	/** The one before the frame, and the other from it on. */
	private static FilamentTrack joined(final FilamentTrack before, final FilamentTrack after,
		final int frame) {
		List<Observation> head = before.frames().subList(0, frame - 1),
			tail = after.frames().subList(frame - 1, after.frames().size());
		if (isAgainst(head, tail)) {
			if (contours(head) < contours(tail))
				head = turned(head);
			else
				tail = turned(tail);
		}
		final List<Observation> all = new ArrayList<>(head);
		all.addAll(tail);
		final double share = contours(head) / (double) Math.max(1, contours(head) + contours(tail));
		return new FilamentTrack(before.id(), before.anchor(), before.fixedEnd(),
			share * before.length() + (1 - share) * after.length(),
			Math.hypot(share * before.lengthError(), (1 - share) * after.lengthError()), all);
	}

	private static long contours(final List<Observation> frames) {
		return frames.stream().filter(o -> o.contour().isPresent()).count();
	}

	private static boolean isAgainst(final List<Observation> head, final List<Observation> tail) {
		final Optional<Polyline> last = head.stream().flatMap(o -> o.contour().stream())
			.reduce((a, b) -> b),
			next = tail.stream().flatMap(o -> o.contour().stream()).findFirst();
		return last.isPresent() && next.isPresent()
			&& apart(last.get(), next.get().reversed()) < apart(last.get(), next.get());
	}

	private static double apart(final Polyline a, final Polyline b) {
		return a.first().distanceTo(b.first()) + a.last().distanceTo(b.last());
	}

	private static List<Observation> turned(final List<Observation> frames) {
		final Function<Alternative, Alternative> turn = a -> new Alternative(a.contour().reversed(),
			a.cost());
		return frames.stream().map(o -> o.contour().map(c -> o.withContour(c.reversed())).orElse(o)
			.withAlternatives(o.alternatives().stream().map(turn).toList())).toList();
	}
}
