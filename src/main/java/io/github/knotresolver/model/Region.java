package io.github.knotresolver.model;

import java.util.Optional;

import net.imglib2.RandomAccessibleInterval;
import net.imglib2.view.Views;

import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.geometry.Polyline;

/**
 * The part of a movie that a search is limited to, in pixels; results are in the
 * whole movie's pixels all the same.
 *
 * @param x first column
 * @param y first row
 * @param width number of columns
 * @param height number of rows
 */
public record Region(int x, int y, int width, int height) {

	/** Too small to hold a filament. */
	private static final int LEAST = 8;

	public Region {
		if (width < LEAST || height < LEAST)
			throw new UserException("The region " + x + "," + y + "," + width + "," + height
				+ " is too small for a filament; it must have " + LEAST + " x " + LEAST
				+ " pixels at least, or leave it out to search the whole image.");
	}

	/** @return {@code x,y,width,height}, as options have it */
	@Override
	public String toString() {
		return x + "," + y + "," + width + "," + height;
	}

	/**
	 * @param movie a movie
	 * @return this region
	 * @throws UserException if it reaches outside of the movie, in one
	 *           sentence
	 */
	public Region inside(final Movie movie) {
		if (x < 0 || y < 0 || x + width > movie.width() || y + height > movie.height())
			throw new UserException("The region " + this + " (x,y,width,height)"
				+ " reaches outside of '" + movie.name() + "', which has " + movie.width() + " x "
				+ movie.height() + " pixels; move it, or leave it out to search the whole image.");
		return this;
	}

	/**
	 * @param movie a movie
	 * @return this part of it; pixels are shared
	 * @throws UserException if the region reaches outside of it
	 */
	public Movie of(final Movie movie) {
		inside(movie);
		return new Movie(movie.name(), part(movie.frames()), movie.calibration());
	}

	private <T> RandomAccessibleInterval<T> part(final RandomAccessibleInterval<T> frames) {
		final long[] min = frames.minAsLongArray();
		return Views.zeroMin(Views.interval(frames, new long[]{min[0] + x, min[1] + y, min[2]},
			new long[]{min[0] + x + width - 1, min[1] + y + height - 1, frames.max(2)}));
	}

	/**
	 * @param p settings of the whole movie
	 * @return the settings in this part's own pixels, where the whole is searched
	 * @throws UserException if the fixed end lies outside, in one
	 *           sentence
	 */
	public Settings of(final Settings p) {
		return p.edit().region(Optional.empty()).fixedEnd(p.fixedEnd().map(this::inside))
			.constraints(
				p.constraints().stream().map(c -> c.with(shape -> moved(shape, -x, -y))).toList())
			.build();
	}

	private Point inside(final Point end) {
		final Point moved = new Point(end.x() - x, end.y() - y);
		if (moved.x() < -0.5 || moved.y() < -0.5 || moved.x() > width - 0.5
			|| moved.y() > height - 0.5)
			throw new UserException("fixed_end " + end + " lies outside the region " + this
				+ " (x,y,width,height); move the region, or leave it out to search the whole image.");
		return moved;
	}

	/**
	 * @param track a filament in this part's pixels
	 * @return the filament in the whole movie's pixels
	 */
	public FilamentTrack back(final FilamentTrack track) {
		return new FilamentTrack(track.id(), track.anchor(), track.fixedEnd().map(this::back),
			track.length(), track.lengthError(), track.frames().stream().map(this::back).toList());
	}

	private Observation back(final Observation o) {
		return new Observation(o.frame(), o.status(), o.reason(), o.contour().map(this::back),
			o.junctions(), o.candidates(), o.cost(), o.confidence(), o.visible(), o.alternatives()
				.stream().map(a -> new Alternative(back(a.contour()), a.cost())).toList());
	}

	/**
	 * @param contour a contour in this part's pixels
	 * @return the contour in the whole movie's pixels
	 */
	public Polyline back(final Polyline contour) {
		return moved(contour, x, y);
	}

	/**
	 * @param point a point in this part's pixels
	 * @return the point in the whole movie's pixels
	 */
	public Point back(final Point point) {
		return new Point(point.x() + x, point.y() + y);
	}

	private static Polyline moved(final Polyline contour, final int dx, final int dy) {
		final double[] x = contour.xs(), y = contour.ys();
		for (int i = 0; i < x.length; i++) {
			x[i] += dx;
			y[i] += dy;
		}
		return Polyline.of(x, y);
	}
}
