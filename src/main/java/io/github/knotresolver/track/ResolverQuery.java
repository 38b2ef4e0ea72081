package io.github.knotresolver.track;

import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.OptionalDouble;

import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.geometry.Polyline;

/**
 * What a resolver starts from.
 *
 * @param frames the frames to resolve, in order of time
 * @param fixedEnd the fixed end in pixels
 * @param length the filament's length in pixels, above 0; empty to estimate it
 * @param corrections contours the user gave, by 1-based frame, fixed end first, in
 *          pixels; such a frame has no other candidate
 */
public record ResolverQuery(List<FrameGraph> frames, Point fixedEnd, OptionalDouble length,
	Map<Integer, Polyline> corrections) {

	public ResolverQuery {
		frames = List.copyOf(frames);
		corrections = Map.copyOf(corrections);
		Objects.requireNonNull(fixedEnd);
		if (length.isPresent() && !(length.getAsDouble() > 0))
			throw new IllegalArgumentException(
				"The filament's length must be above 0 pixels, but is " + length.getAsDouble()
					+ ".");
	}
}
