
package io.github.knotresolver.model;

/** Whether filaments have an end that is held. */
public enum AnchorChoice {
	/** The movie tells, for each filament. */
	AUTO,
	/** All filaments are held at one end. */
	CLAMPED,
	/** No filament is held. */
	FREE
}
