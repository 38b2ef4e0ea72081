package io.github.knotresolver.session;

import java.util.List;
import java.util.OptionalDouble;
import java.util.function.UnaryOperator;

import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.model.Alternative;
import io.github.knotresolver.model.Constraint;
import io.github.knotresolver.model.FilamentTrack;
import io.github.knotresolver.model.Observation;
import io.github.knotresolver.model.Settings;

/**
 * The pixels that a movie is resolved in: blocks of its own, so that wide lines are as
 * wide as others there, and only those of the box around what was found.
 *
 * @param binning edge of a block in the movie's pixels, at least 1
 * @param x first column of the box, in blocks
 * @param y first row of the box, in blocks
 */
record WorkingPixels(int binning, int x, int y) {

	/** The movie's own pixels. */
	static final WorkingPixels SAME = new WorkingPixels(1, 0, 0);

	/** @return settings in the movie's pixels, in these */
	Settings of(final Settings p) {
		if (equals(SAME))
			return p;
		final OptionalDouble length = p.length().isPresent()
			? OptionalDouble.of(p.length().getAsDouble() / binning)
			: OptionalDouble.empty();
		return p.edit().fixedEnd(p.fixedEnd().map(this::in)).length(length)
			.constraints(in(p.constraints())).build();
	}

	/** @return what was said in the movie's pixels, in these */
	List<Constraint> in(final List<Constraint> said) {
		return said.stream().map(c -> c.with(shape -> moved(shape, this::in))).toList();
	}

	/** @return a place in the movie's pixels, in these */
	Point in(final Point p) {
		return new Point((p.x() - centre()) / binning - x, (p.y() - centre()) / binning - y);
	}

	/** @return a place in these pixels, in the movie's */
	Point out(final Point p) {
		return new Point((p.x() + x) * binning + centre(), (p.y() + y) * binning + centre());
	}

	/** @return a contour in these pixels, in the movie's */
	Polyline out(final Polyline contour) {
		return moved(contour, this::out);
	}

	/** @return a filament in these pixels, in the movie's */
	FilamentTrack out(final FilamentTrack track) {
		return equals(SAME)
			? track
			: new FilamentTrack(track.id(), track.anchor(), track.fixedEnd().map(this::out),
				track.length() * binning, track.lengthError() * binning,
				track.frames().stream().map(this::out).toList());
	}

	private Observation out(final Observation o) {
		return new Observation(o.frame(), o.status(), o.reason(),
			o.contour().map(c -> moved(c, this::out)), o.junctions(), o.candidates(), o.cost(),
			o.confidence(), o.visible(), o.alternatives().stream()
				.map(a -> new Alternative(moved(a.contour(), this::out), a.cost())).toList());
	}

	private static Polyline moved(final Polyline c, final UnaryOperator<Point> move) {
		final double[] xs = new double[c.size()], ys = new double[c.size()];
		for (int i = 0; i < xs.length; i++) {
			final Point moved = move.apply(c.point(i));
			xs[i] = moved.x();
			ys[i] = moved.y();
		}
		return Polyline.of(xs, ys);
	}

	/** Where the first block's centre lies. */
	private double centre() {
		return (binning - 1) / 2.0;
	}
}
