package io.github.knotresolver.evaluate.like;

import net.imglib2.type.numeric.IntegerType;
import net.imglib2.type.numeric.integer.UnsignedByteType;

import io.github.knotresolver.image.Pixels;
import io.github.knotresolver.model.Movie;
import io.github.knotresolver.simulate.BitDepth;

/**
 * The grey values that a movie uses, and how they become those of a drawn movie of 8 or 16 bit.
 * Whole numbers stay as they are; real numbers are spread over 16 bit.
 *
 * @param lowest smallest value
 * @param highest largest value
 * @param clipped whether brighter light was cut off at the largest value
 * @param depth of the drawn movie
 * @param black the value that becomes 0 there
 * @param step the difference that becomes 1
 */
record GreyRange(double lowest, double highest, boolean clipped, BitDepth depth, double black,
	double step) {

	/** Of the range of 16 bit, the share that a movie of real numbers fills. */
	private static final double FILLED = 0.5;

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
		final boolean clipped = atHighest > PILE * pixels;
		final Object type = movie.frames().getType();
		if (type instanceof IntegerType)
			return new GreyRange(lowest, highest, clipped,
				type instanceof UnsignedByteType ? BitDepth.EIGHT : BitDepth.SIXTEEN, 0, 1);
		return new GreyRange(lowest, highest, clipped, BitDepth.SIXTEEN, lowest,
			(highest - lowest) / (FILLED * BitDepth.SIXTEEN.maximum()));
	}

	/** @return whether a value is cut off at the upper end */
	boolean isCut(final double value) {
		return clipped && value >= highest;
	}

	/** @return the drawn grey value, neither rounded nor clipped */
	double drawn(final double value) {
		return (value - black) / step;
	}

	/**
	 * @return the same look, its figures in the movie's own grey values; profile and
	 *         range stay as drawn
	 */
	Appearance undone(final Appearance drawn) {
		return new Appearance(black + step * drawn.background(), step * drawn.noise(),
			step * drawn.noiseOnLine(), step * drawn.peak(), drawn.width(), drawn.saturating(),
			drawn.profile(), drawn.along(), drawn.range());
	}
}
