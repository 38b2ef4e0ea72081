package io.github.knotresolver.evaluate.like;

import net.imglib2.type.numeric.IntegerType;
import net.imglib2.type.numeric.integer.UnsignedByteType;

import io.github.knotresolver.model.Movie;
import io.github.knotresolver.simulate.BitDepth;

/**
 * From a movie's grey values to those of a drawn movie of 8 or 16 bit. Whole
 * numbers stay as they are; real numbers are spread over 16 bit.
 *
 * @param depth of the drawn movie
 * @param black the value that becomes 0
 * @param step the difference that becomes 1
 */
record GreyScale(BitDepth depth, double black, double step) {

	/** Of the range of 16 bit, the share that a movie of real numbers fills. */
	private static final double FILLED = 0.5;

	static GreyScale of(final Movie movie, final GreyRange range) {
		final Object type = movie.frames().getType();
		if (type instanceof UnsignedByteType)
			return new GreyScale(BitDepth.EIGHT, 0, 1);
		if (type instanceof IntegerType)
			return new GreyScale(BitDepth.SIXTEEN, 0, 1);
		final double span = range.highest() - range.lowest();
		return new GreyScale(BitDepth.SIXTEEN, range.lowest(),
			span / (FILLED * BitDepth.SIXTEEN.maximum()));
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
