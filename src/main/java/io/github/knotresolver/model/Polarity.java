package io.github.knotresolver.model;

/** Whether filaments are brighter or darker than their background. */
public enum Polarity {

	/** To be found in the movie. */
	AUTO,
	/** Light on a darker background, as in fluorescence. */
	BRIGHT,
	/** Shadow on a lighter background, as in transmitted light. */
	DARK;

	/** @return -1 for dark filaments, 1 otherwise: what pixels are multiplied by */
	public int sign() {
		return this == DARK ? -1 : 1;
	}
}
