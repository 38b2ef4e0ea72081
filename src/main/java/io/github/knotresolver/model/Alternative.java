package io.github.knotresolver.model;

import java.util.Objects;

import io.github.knotresolver.geometry.Polyline;

/**
 * Another contour that a frame might have.
 *
 * @param contour the contour in pixels, from the fixed end to the tip
 * @param cost its price in the movie, comparable with that of the frame's
 *          observation (smaller is better)
 */
public record Alternative(Polyline contour, double cost) {

	public Alternative {
		Objects.requireNonNull(contour);
	}
}
