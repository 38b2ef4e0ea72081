package io.github.knotresolver.ui.model;

import java.util.ArrayList;
import java.util.List;

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
 *          tip, the places that it passes, and any number of refused contours; or that it is right
 */
record Edits(List<Constraint> said) {

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
	}

	/** @return what a file or an earlier run says, as if it had been said here */
	static Edits of(final List<Constraint> said) {
		Edits edits = new Edits(List.of());
		for (final Constraint c : said)
			edits = edits.with(c);
		return edits;
	}

	/** @return what decides the result */
	List<Constraint> deciding() {
		return said.stream().filter(c -> c.kind() != Kind.CHECKED).toList();
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
			if (!isOfSamePlace(c, next) || stands(c.kind(), next.kind()))
				kept.add(c);
			else if (next.kind() == Kind.THROUGH && c.kind() == Kind.THROUGH)
				added = added.with(places -> joined(c.shape(), places));
		kept.add(added);
		return new Edits(kept);
	}

	/** Whether a word stays beside another one that comes after it. */
	private static boolean stands(final Kind earlier, final Kind next) {
		if (earlier == Kind.SWAP || next == Kind.SWAP)
			return true;
		if (earlier == Kind.CHECKED || next == Kind.CHECKED)
			return earlier != Kind.CHECKED;
		return next != Kind.CONTOUR && earlier != Kind.CONTOUR
			&& (next != earlier || next == Kind.NOT);
	}

	/** @return the same without a word about a filament in a frame, except that it was exchanged */
	Edits without(final Place place) {
		return new Edits(said.stream().filter(c -> c.filament() != place.filament
			|| c.frame() != place.frame || c.kind() == Kind.SWAP).toList());
	}

	/**
	 * Two filaments are exchanged from a frame on; what was said of their contours from there on is
	 * said of the same contours. The same two once more are as they were.
	 *
	 * @param swap the word
	 * @param other number of the filament that it is exchanged with
	 */
	Edits exchanging(final Constraint swap, final int other) {
		final List<Constraint> next = new ArrayList<>();
		boolean back = false;
		for (final Constraint c : said)
			if (c.kind() == Kind.SWAP && c.frame() == swap.frame()
				&& (c.filament() == swap.filament() || c.filament() == other))
				back = true;
			else if (c.frame() < swap.frame())
				next.add(c);
			else if (c.filament() == swap.filament())
				next.add(c.of(other));
			else
				next.add(c.filament() == other ? c.of(swap.filament()) : c);
		if (!back)
			next.add(CorrectionsCsv.asWritten(swap));
		return new Edits(next);
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
