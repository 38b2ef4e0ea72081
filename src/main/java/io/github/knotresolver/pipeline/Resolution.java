package io.github.knotresolver.pipeline;

import java.util.List;
import java.util.Optional;

import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.image.Movie;
import io.github.knotresolver.track.TrackedFrame;

/**
 * The result: one row for every frame of the movie.
 *
 * @param movie the movie, with its calibration
 * @param parameters what it was resolved with
 * @param fixedEnd the clamped end in pixels; empty if no filament was found
 * @param length the filament's length in pixels that was used; NaN if there is
 *          none
 * @param lengthUncertainty its standard error in pixels; NaN if it was told or
 *          is not known
 * @param frames what was found, in order, one for every frame of the movie
 * @param notes what a user should know about the run: limits that were hit,
 *          choices that were made; one sentence each
 */
public record Resolution(Movie movie, Parameters parameters, Optional<Point> fixedEnd,
	double length, double lengthUncertainty, List<TrackedFrame> frames, List<String> notes) {

	public Resolution {
		if (frames.size() != movie.size())
			throw new IllegalArgumentException("The movie has " + movie.size()
				+ " frames, but the result has " + frames.size() + ".");
		frames = List.copyOf(frames);
		notes = List.copyOf(notes);
	}

	/** @return how many frames have a contour */
	public int resolved() {
		return (int) frames.stream().filter(f -> f.contour().isPresent()).count();
	}
}
