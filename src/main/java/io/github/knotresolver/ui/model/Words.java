package io.github.knotresolver.ui.model;

import java.util.List;
import java.util.Optional;

import io.github.knotresolver.geometry.Drag;
import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.model.Anchor;
import io.github.knotresolver.model.Constraint;
import io.github.knotresolver.model.Constraint.Kind;
import io.github.knotresolver.model.FilamentTrack;
import io.github.knotresolver.model.Observation;
import io.github.knotresolver.model.Tracks;
import io.github.knotresolver.model.UserException;

/**
 * What a person means who points at a filament in a frame, as a word that the solver knows.
 *
 * @param tracks the result that is seen
 * @param filament the one that is looked at
 * @param frame likewise, from 1
 */
record Words(Tracks tracks, FilamentTrack filament, int frame) {

	private Observation seen() {
		return filament.frames().get(frame - 1);
	}

	private Constraint word(final Kind kind, final Polyline shape) {
		return new Constraint(filament.id(), frame, kind, shape);
	}

	/** Where filaments are free or several, what is dragged is taken as it is drawn. */
	private boolean isScene() {
		return tracks.filaments().size() > 1 || filament.anchor() == Anchor.FREE;
	}

	/** @return the contour passes here; in a scene, that which is shown is bent to do so */
	Constraint through(final Point place) {
		return isScene()
			? word(Kind.CONTOUR, Drag.nearest(shown(), place).to(place))
			: word(Kind.THROUGH, Polyline.of(List.of(place)));
	}

	/** @return the contour ends here; likewise */
	Constraint tip(final Point place) {
		return isScene()
			? word(Kind.CONTOUR, Drag.tip(shown()).to(place))
			: word(Kind.TIP, Polyline.of(List.of(place)));
	}

	/** @return the contour is as it was dragged */
	Constraint dragged(final Drag drag, final Point place) {
		if (isScene())
			return word(Kind.CONTOUR, drag.to(place));
		return drag.isOfTip() ? tip(place) : through(place);
	}

	private Polyline shown() {
		return seen().contour().orElseThrow(() -> new UserException("Filament " + filament.id()
			+ " has no contour in frame " + frame + " that could be moved; draw the contour."));
	}

	/** @return what is shown is right, even if there is nothing */
	Constraint accepted() {
		return seen().contour().map(c -> Constraint.checked(filament.id(), frame, c)).orElseGet(
			() -> Constraint.checkedNone(filament.id(), frame, last().orElse(new Point(0, 0))));
	}

	private Optional<Point> last() {
		return filament.frames().stream().flatMap(o -> o.contour().stream()).map(Polyline::first)
			.findFirst();
	}

	/** @return from here on, the filament is another one, and that one is this */
	Constraint exchanged(final FilamentTrack other) {
		final Polyline mine = shown(), theirs = other.frames().get(frame - 1).contour()
			.orElseThrow(() -> new UserException("Filament " + other.id()
				+ " has no contour in frame " + frame + "; go to a frame that shows both."));
		for (final FilamentTrack f : new FilamentTrack[]{filament, other})
			if (f.anchor() == Anchor.CLAMPED)
				throw new UserException("Filament " + f.id()
					+ " is held at its first end, which stays where it is, so it cannot be exchanged; draw the contour.");
		return word(Kind.SWAP,
			Polyline.of(List.of(farthest(mine, theirs), farthest(theirs, mine))));
	}

	private static Point farthest(final Polyline curve, final Polyline from) {
		Point best = curve.first();
		for (int i = 1; i < curve.size(); i++)
			if (from.distanceTo(curve.point(i)) > from.distanceTo(best))
				best = curve.point(i);
		return best;
	}
}
