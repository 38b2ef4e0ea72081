package io.github.knotresolver.model;

import java.util.List;
import java.util.Objects;
import java.util.Optional;

import io.github.knotresolver.geometry.Point;

/**
 * One filament through the movie.
 *
 * @param id number of the filament, from 1
 * @param anchor how it is held
 * @param fixedEnd where it is clamped, in pixels; empty if it is free or not
 *          known
 * @param length its length in pixels that was used; NaN if there is none
 * @param lengthError the length's standard error in pixels; NaN if the length
 *          was told or its error is not known
 * @param frames what was found, in order, one for every frame of the movie
 */
public record FilamentTrack(int id, Anchor anchor, Optional<Point> fixedEnd, double length,
	double lengthError, List<Observation> frames) {

	public FilamentTrack {
		if (id < 1)
			throw new IllegalArgumentException(
				"Filaments count from 1, but this is filament " + id + ".");
		Objects.requireNonNull(anchor);
		Objects.requireNonNull(fixedEnd);
		frames = List.copyOf(frames);
		for (int i = 0; i < frames.size(); i++)
			if (frames.get(i).frame() != i + 1)
				throw new IllegalArgumentException(
					"Row " + (i + 1) + " of filament " + id + " must be frame " + (i + 1)
						+ ", but is frame " + frames.get(i).frame() + ".");
	}

	/** @return how many frames have a contour */
	public int resolved() {
		return (int) frames.stream().filter(f -> f.contour().isPresent()).count();
	}
}
