package io.github.knotresolver.evaluate.like;

import io.github.knotresolver.image.Pixels;
import io.github.knotresolver.model.Movie;

/**
 * The grey values that a movie uses.
 *
 * @param lowest smallest value
 * @param highest largest value
 * @param clipped whether brighter light was cut off at the largest value
 */
record GreyRange(double lowest, double highest, boolean clipped) {

	/** In a movie that is not clipped, fewer pixels have the largest value. */
	private static final double PILE = 0.003;

	static GreyRange of(final Movie movie) {
		double lowest = Double.POSITIVE_INFINITY, highest = Double.NEGATIVE_INFINITY;
		long atHighest = 0, pixels = 0;
		for (int t = 0; t < movie.size(); t++)
			for (final double value : Pixels.doubles(movie.frame(t))) {
				// Comparisons are false for pixels without a value.
				if (value < lowest)
					lowest = value;
				if (value > highest) {
					highest = value;
					atHighest = 0;
				}
				if (value == highest)
					atHighest++;
				pixels++;
			}
		return new GreyRange(lowest, highest, atHighest > PILE * pixels);
	}

	/** @return whether a value is cut off at the upper end */
	boolean isCut(final double value) {
		return clipped && value >= highest;
	}
}
