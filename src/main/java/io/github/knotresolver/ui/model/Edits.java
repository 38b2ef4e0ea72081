package io.github.knotresolver.ui.model;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.SortedSet;
import java.util.TreeSet;

import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.io.CorrectionsCsv;
import io.github.knotresolver.model.Constraint;
import io.github.knotresolver.model.Constraint.Kind;

/**
 * All that a person has said in a review: what {@code corrections.csv} can hold, with the decimals
 * that it holds, so that a run with that file is a run with these words.
 *
 * @param said of frames, in their order; of each filament in each frame at most one contour, or one
 *          tip, the places that it passes, and any number of refused contours
 * @param checked which contours were found right
 */
record Edits(List<Constraint> said, SortedSet<Place> checked) {

	/**
	 * One filament in one frame.
	 *
	 * @param filament number of the filament, from 1
	 * @param frame 1-based number of the frame
	 */
	record Place(int filament, int frame) implements Comparable<Place> {

		@Override
		public int compareTo(final Place other) {
			return frame == other.frame
				? Integer.compare(filament, other.filament)
				: Integer.compare(frame, other.frame);
		}
	}

	Edits {
		said = Constraint.sorted(said);
		checked = Collections.unmodifiableSortedSet(new TreeSet<>(checked));
	}

	/** @return what a file or an earlier run says, as if it had been said here */
	static Edits of(final List<Constraint> said) {
		Edits edits = new Edits(List.of(), new TreeSet<>());
		for (final Constraint c : said)
			edits = edits.with(c);
		return edits;
	}

	/**
	 * @param next what a person says now; it overrules what cannot be true beside it: a whole contour
	 *          all else about that filament in that frame, anything else a whole contour, and a tip
	 *          another tip
	 * @return what is said from now on
	 */
	Edits with(final Constraint next) {
		final List<Constraint> kept = new ArrayList<>();
		Constraint added = CorrectionsCsv.asWritten(next);
		for (final Constraint c : said)
			if (!isOfSamePlace(c, next))
				kept.add(c);
			else if (next.kind() == Kind.THROUGH && c.kind() == Kind.THROUGH)
				added = added.with(places -> joined(c.shape(), places));
			else if (next.kind() != Kind.CONTOUR && c.kind() != Kind.CONTOUR
				&& (next.kind() != Kind.TIP || c.kind() != Kind.TIP))
				kept.add(c);
		kept.add(added);
		return new Edits(kept, checked);
	}

	/** @return the same without a word about a filament in a frame */
	Edits without(final Place place) {
		return new Edits(said.stream()
			.filter(c -> c.filament() != place.filament || c.frame() != place.frame).toList(),
			checked);
	}

	/** @return the same, and what is shown of a filament in a frame is right */
	Edits accepting(final Place place) {
		final SortedSet<Place> more = new TreeSet<>(checked);
		more.add(place);
		return new Edits(said, more);
	}

	private static boolean isOfSamePlace(final Constraint a, final Constraint b) {
		return a.frame() == b.frame() && a.filament() == b.filament();
	}

	private static Polyline joined(final Polyline before, final Polyline more) {
		final List<Point> points = new ArrayList<>();
		for (final Polyline part : List.of(before, more))
			for (int i = 0; i < part.size(); i++)
				if (!points.contains(part.point(i)))
					points.add(part.point(i));
		return Polyline.of(points);
	}
}
