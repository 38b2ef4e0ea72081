package io.github.knotresolver.fit;

import java.util.Arrays;

import io.github.knotresolver.geometry.Point;

/**
 * What a movie says about its filament.
 *
 * @param model what a line looks like
 * @param amplitude brightness of a strand, in the units of the frames that were
 *          looked at
 * @param length of the filament in pixels
 * @param lengthError standard error of the length in pixels
 * @param fixedEnd the clamped end in pixels
 * @param guessed whether the length is a guess: where the light of its ends ends did not settle, or
 *          one of them is far brighter than the filament
 */
public record FilamentEstimate(LineModel model, double amplitude, double length, double lengthError,
	Point fixedEnd, boolean guessed) {

	/**
	 * @param told the length in pixels, which is known
	 * @return the same with that length
	 */
	public FilamentEstimate withLength(final double told) {
		return new FilamentEstimate(model, amplitude, told, Double.NaN, fixedEnd, false);
	}

	/**
	 * @param other another length in pixels
	 * @param error its standard error
	 * @return the same with that length
	 */
	public FilamentEstimate withLength(final double other, final double error) {
		return new FilamentEstimate(model, amplitude, other, error, fixedEnd, guessed);
	}

	/**
	 * @param end where the fixed end is, in pixels
	 * @return the same with that fixed end
	 */
	public FilamentEstimate withFixedEnd(final Point end) {
		return new FilamentEstimate(model, amplitude, length, lengthError, end, guessed);
	}

	/**
	 * The same filament in other units of light: what fits cost depends on how bright a strand is
	 * taken for, since residuals are cut off at a share of it.
	 *
	 * @param strand what a brightness of 1 is in the frames' units, above 0
	 * @return as bright in the frames' units
	 */
	public FilamentEstimate inUnitsOf(final double strand) {
		return new FilamentEstimate(
			model.withBrightness(
				Arrays.stream(model.brightness()).map(b -> b * amplitude / strand).toArray()),
			strand, length, lengthError, fixedEnd, guessed);
	}

	/**
	 * @param isGuessed whether its length is a guess
	 * @return the same
	 */
	public FilamentEstimate withGuessed(final boolean isGuessed) {
		return new FilamentEstimate(model, amplitude, length, lengthError, fixedEnd, isGuessed);
	}

	/**
	 * @param wasGuessed whether its length is a guess for another reason
	 * @return the same, whose length may be a guess
	 */
	public FilamentEstimate orGuessed(final boolean wasGuessed) {
		return withGuessed(guessed || wasGuessed);
	}
}
