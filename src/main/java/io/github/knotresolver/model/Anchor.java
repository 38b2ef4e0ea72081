package io.github.knotresolver.model;

import java.util.Locale;

/** How a filament is held. */
public enum Anchor {

	/** One end is held at a place; its contours begin there. */
	CLAMPED,
	/** No end is held; its contours run from the trailing to the leading end. */
	FREE;

	/** @return the name as written to files: lower case */
	public String label() {
		return name().toLowerCase(Locale.ROOT);
	}
}
