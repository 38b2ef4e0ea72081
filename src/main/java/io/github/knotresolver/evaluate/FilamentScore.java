package io.github.knotresolver.evaluate;

import java.util.OptionalInt;

/**
 * A true filament and the one of the result that it was given.
 *
 * @param filament number of the true filament
 * @param result number of the result's filament; empty if it was given none
 * @param reversed whether the result runs from its last end to its first
 * @param evaluation frame by frame, the result turned round if it is reversed
 */
public record FilamentScore(int filament, OptionalInt result, boolean reversed,
	Evaluation evaluation) {

	/** @return whether there is a filament of the result for it */
	public boolean isGiven() {
		return result.isPresent();
	}
}
