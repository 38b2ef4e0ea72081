package io.github.knotresolver.pipeline;

import java.util.EnumSet;
import java.util.List;
import java.util.Set;

import io.github.knotresolver.fit.LineModel;
import io.github.knotresolver.image.Movie;
import io.github.knotresolver.image.Pixels;

/**
 * Whether the brightest pixels of a movie were cut off, by the camera or by a
 * contrast stretch. Where a single strand already reaches the ceiling, strands that
 * cross cannot be brighter.
 *
 * @param share the share of all pixels that have the movie's largest value
 */
record Clipping(double share) {

	/** In a movie that is not clipped, few pixels share the largest value. */
	private static final double CLIPPED = 0.003;

	static Clipping of(final Movie movie, final List<Integer> frames) {
		double largest = Double.NEGATIVE_INFINITY;
		long count = 0, pixels = 0;
		for (final int frame : frames)
			for (final double value : Pixels.doubles(movie.frame(frame - 1))) {
				pixels++;
				if (value > largest) {
					largest = value;
					count = 0;
				}
				if (value == largest)
					count++;
			}
		return new Clipping((double) count / pixels);
	}

	/** How strands may add up in such a movie. */
	Set<LineModel.Kind> kinds() {
		return share > CLIPPED
			? EnumSet.of(LineModel.Kind.SATURATING)
			: EnumSet.allOf(LineModel.Kind.class);
	}
}
