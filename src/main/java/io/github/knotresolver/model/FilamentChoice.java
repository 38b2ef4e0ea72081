
package io.github.knotresolver.model;

/** How many filaments of a movie are delivered. */
public enum FilamentChoice {
	/** The clamped one: that of the told fixed end, or the most likely one. */
	ONE,
	/** Every filament of the field, clamped or free. */
	ALL
}
