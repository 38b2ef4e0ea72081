package io.github.knotresolver.track;

import java.util.List;
import java.util.OptionalDouble;

import io.github.knotresolver.model.Observation;

/**
 * What a resolver found.
 *
 * @param frames one for each frame asked for, in the same order
 * @param length the filament's length in pixels that was used; empty if none was
 */
public record Track(List<Observation> frames, OptionalDouble length) {

	public Track {
		frames = List.copyOf(frames);
	}
}
