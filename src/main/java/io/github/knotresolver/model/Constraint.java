package io.github.knotresolver.model;

import java.util.Arrays;
import java.util.Collection;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Objects;
import java.util.Optional;
import java.util.TreeSet;
import java.util.function.UnaryOperator;

import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.geometry.Polyline;

/**
 * What a person says about one filament in one frame.
 *
 * @param filament number of the filament, from 1
 * @param frame 1-based number of the frame
 * @param kind what is said
 * @param shape the contour, fixed end first, or the places, in pixels
 */
public record Constraint(int filament, int frame, Kind kind,
	Polyline shape) implements Comparable<Constraint> {

	/** What a person can say. */
	public enum Kind {
		/** This is the whole contour. */
		CONTOUR,
		/** The contour passes these places, in any order. */
		THROUGH,
		/** The contour's free tip is here. */
		TIP,
		/** This contour is wrong. */
		NOT,
		/**
		 * From this frame on, this filament is the one that passes the second place, and that one is
		 * this, which passes the first.
		 */
		SWAP,
		/**
		 * What was found is right: a contour that passes these places, or, if it is one place, none.
		 * It decides nothing.
		 */
		CHECKED;

		/** @return whether it is said of the contour, and decides it */
		public boolean isOfContour() {
			return this != SWAP && this != CHECKED;
		}

		/** @return the name as written to files: lower case */
		public String label() {
			return name().toLowerCase(Locale.ROOT);
		}
	}

	/** A contour that was found right is the same as long as it is this near (pixels), at so many places. */
	private static final double SAME = 1;
	private static final int PLACES = 5;

	private static final Comparator<Constraint> ORDER = Comparator.comparingInt(Constraint::frame)
		.thenComparingInt(Constraint::filament).thenComparing(Constraint::kind)
		.thenComparing(c -> c.shape, Constraint::compare);

	public Constraint {
		Objects.requireNonNull(kind);
		if (filament < 1)
			throw new UserException(
				"A correction must be of a filament counted from 1, but is of " + filament + ".");
		if (frame < 1)
			throw new UserException(
				"A correction must be of a frame counted from 1, but is of " + frame + ".");
		final boolean whole = kind == Kind.CONTOUR || kind == Kind.NOT;
		if (whole && (shape.size() < 2 || !(shape.length() > 1)))
			throw new UserException("The correction of frame " + frame
				+ " needs at least two points, more than a pixel apart, from the fixed end to the tip.");
		if (kind == Kind.TIP && shape.size() != 1)
			throw new UserException(
				"The tip in frame " + frame + " must be one point, but has " + shape.size() + ".");
		if (kind == Kind.SWAP && shape.size() != 2)
			throw new UserException("The swap in frame " + frame
				+ " must be two points, one on each filament, but has " + shape.size() + ".");
	}

	/**
	 * @param frame 1-based number of the frame
	 * @param contour the whole contour of the first filament, in pixels
	 * @return the constraint
	 */
	public static Constraint contour(final int frame, final Polyline contour) {
		return new Constraint(1, frame, Kind.CONTOUR, contour);
	}

	/**
	 * @param filament number of the filament, from 1
	 * @param frame 1-based number of the frame
	 * @param found its contour, fixed end first, in pixels
	 * @return the word that this contour is right
	 */
	public static Constraint checked(final int filament, final int frame, final Polyline found) {
		return new Constraint(filament, frame, Kind.CHECKED, places(found));
	}

	private static Polyline places(final Polyline contour) {
		final Point[] places = new Point[PLACES];
		Arrays.setAll(places, i -> contour.at(contour.length() * i / (PLACES - 1)));
		return Polyline.of(List.of(places));
	}

	/**
	 * @param filament number of the filament, from 1
	 * @param frame 1-based number of the frame
	 * @param near where it was last, in pixels
	 * @return the word that it is right that there is no contour
	 */
	public static Constraint checkedNone(final int filament, final int frame, final Point near) {
		return new Constraint(filament, frame, Kind.CHECKED, Polyline.of(List.of(near)));
	}

	/**
	 * @param found what was found of the filament in the frame
	 * @return whether this is the word that it is right, and it still is what was meant
	 */
	boolean confirms(final Optional<Polyline> found) {
		if (kind != Kind.CHECKED)
			return false;
		if (found.isEmpty() || shape.size() == 1)
			return found.isEmpty() && shape.size() == 1;
		return passes(found.get(), shape);
	}

	/**
	 * @param found a contour of the filament in the frame
	 * @return whether this is the word that it is wrong
	 */
	public boolean refuses(final Polyline found) {
		return kind == Kind.NOT && passes(found, places(shape));
	}

	private static boolean passes(final Polyline contour, final Polyline places) {
		for (int i = 0; i < places.size(); i++)
			if (contour.distanceTo(places.point(i)) > SAME)
				return false;
		return true;
	}

	/**
	 * @param all constraints, in any order
	 * @return the same, each once, in the order of frames
	 */
	public static List<Constraint> sorted(final Collection<Constraint> all) {
		return List.copyOf(new TreeSet<>(all));
	}

	/**
	 * @param change turns a shape into one in other pixels
	 * @return the same constraint in those pixels
	 */
	public Constraint with(final UnaryOperator<Polyline> change) {
		return new Constraint(filament, frame, kind, change.apply(shape));
	}

	/**
	 * @param other number of a filament, from 1
	 * @return the same of that filament
	 */
	public Constraint of(final int other) {
		return new Constraint(other, frame, kind, shape);
	}

	@Override
	public int compareTo(final Constraint other) {
		return ORDER.compare(this, other);
	}

	private static int compare(final Polyline a, final Polyline b) {
		for (int i = 0; i < Math.min(a.size(), b.size()); i++) {
			final int x = Double.compare(a.x(i), b.x(i));
			final int y = x != 0 ? x : Double.compare(a.y(i), b.y(i));
			if (y != 0)
				return y;
		}
		return Integer.compare(a.size(), b.size());
	}
}
