
package io.github.knotresolver.model;

/** How many filaments of a movie are delivered. */
public enum FilamentChoice {
	/** All; the one that is meant where a fixed end, a region or a contour is told. */
	AUTO,
	/** The clamped one: that of the told fixed end, or the most likely one. */
	ONE,
	/** Every filament of the field, clamped or free. */
	ALL
}
