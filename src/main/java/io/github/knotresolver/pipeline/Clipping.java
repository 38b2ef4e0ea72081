package io.github.knotresolver.pipeline;

import java.util.EnumSet;
import java.util.List;
import java.util.Set;

import io.github.knotresolver.fit.LineModel;
import io.github.knotresolver.image.Pixels;
import io.github.knotresolver.model.Movie;

/**
 * Whether the brightest pixels of a movie were cut off, by the camera or by a
 * contrast stretch. Where a single strand already reaches the ceiling, strands that
 * cross cannot be brighter.
 *
 * @param share the share of all pixels that pile up at the movie's largest value
 */
record Clipping(double share) {

	/** More pixels have the largest value than come within this share of the range below it. */
	private static final double BELOW = 0.1;

	/** In a movie that is not clipped, few pixels share the largest value. */
	private static final double CLIPPED = 0.003;

	static Clipping of(final Movie movie, final List<Integer> frames) {
		double largest = Double.NEGATIVE_INFINITY, smallest = Double.POSITIVE_INFINITY;
		for (final int frame : frames)
			for (final double value : Pixels.doubles(movie.frame(frame - 1))) {
				// Comparisons are false for pixels without a value.
				largest = value > largest ? value : largest;
				smallest = value < smallest ? value : smallest;
			}
		final double below = largest - BELOW * (largest - smallest);
		long at = 0, justBelow = 0, pixels = 0;
		for (final int frame : frames)
			for (final double value : Pixels.doubles(movie.frame(frame - 1))) {
				pixels++;
				if (value == largest)
					at++;
				else if (value >= below)
					justBelow++;
			}
		return new Clipping(at > justBelow ? (double) at / pixels : 0);
	}

	/** How strands may add up in such a movie. */
	Set<LineModel.Kind> kinds() {
		return share > CLIPPED
			? EnumSet.of(LineModel.Kind.SATURATING)
			: EnumSet.allOf(LineModel.Kind.class);
	}
}
