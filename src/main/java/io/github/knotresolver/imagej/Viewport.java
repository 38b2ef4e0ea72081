package io.github.knotresolver.imagej;

import java.util.List;

import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.model.FilamentTrack;
import io.github.knotresolver.model.Movie;

/**
 * A part of the image and how large it is shown.
 *
 * @param x left column in pixels
 * @param y top row in pixels
 * @param width width in pixels
 * @param height height in pixels
 * @param scale screen pixels a pixel
 */
record Viewport(int x, int y, int width, int height, double scale) {

	/** From the centre of a pixel, an integer in contours, to its left or upper edge. */
	private static final double HALF = 0.5;

	/** Room around the contours, in pixels. */
	private static final int MARGIN = 12;

	/** The whole image. */
	static Viewport whole(final Movie movie, final double scale) {
		return new Viewport(0, 0, movie.width(), movie.height(), scale);
	}

	/**
	 * The part of the image where the contours of these filaments are; the whole image
	 * if there are none.
	 */
	static Viewport aroundContours(final Movie movie, final List<FilamentTrack> filaments) {
		return around(movie, filaments.stream().flatMap(f -> f.frames().stream())
			.flatMap(f -> f.contour().stream()).toList());
	}

	private static Viewport around(final Movie movie, final List<Polyline> contours) {
		int left = movie.width(), top = movie.height(), right = -1, bottom = -1;
		for (final Polyline contour : contours) {
			for (int i = 0; i < contour.size(); i++) {
				left = Math.min(left, (int) Math.floor(contour.x(i)) - MARGIN);
				right = Math.max(right, (int) Math.ceil(contour.x(i)) + MARGIN);
				top = Math.min(top, (int) Math.floor(contour.y(i)) - MARGIN);
				bottom = Math.max(bottom, (int) Math.ceil(contour.y(i)) + MARGIN);
			}
		}
		if (right < 0)
			return whole(movie, 1);
		left = Math.max(0, left);
		top = Math.max(0, top);
		right = Math.min(movie.width() - 1, right);
		bottom = Math.min(movie.height() - 1, bottom);
		return new Viewport(left, top, right - left + 1, bottom - top + 1, 1);
	}

	/**
	 * @param movie the movie
	 * @param contours some of its contours
	 * @return a part of this shape with these contours in its middle, no larger than this; this if
	 *         there are none, or they need more room
	 */
	Viewport closeUp(final Movie movie, final List<Polyline> contours) {
		final Viewport near = around(movie, contours);
		final double share = Math.max(near.width / (double) width, near.height / (double) height);
		if (contours.isEmpty() || share >= 1)
			return this;
		final int across = (int) Math.ceil(share * width), down = (int) Math.ceil(share * height);
		return new Viewport(inside(near.x + (near.width - across) / 2, across, movie.width()),
			inside(near.y + (near.height - down) / 2, down, movie.height()), across, down, scale);
	}

	private static int inside(final int start, final int size, final int whole) {
		return Math.max(0, Math.min(whole - size, start));
	}

	/** @return the same part at another scale */
	Viewport scaled(final double newScale) {
		return new Viewport(x, y, width, height, newScale);
	}

	/** @return width on the screen */
	int screenWidth() {
		return (int) Math.max(1, Math.rint(width * scale));
	}

	/** @return height on the screen */
	int screenHeight() {
		return (int) Math.max(1, Math.rint(height * scale));
	}

	/** @return where a column is shown */
	double screenX(final double column) {
		return (column + HALF - x) * scale;
	}

	/** @return where a row is shown */
	double screenY(final double row) {
		return (row + HALF - y) * scale;
	}
}
