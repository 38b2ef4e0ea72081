
package io.github.knotresolver.model;

import java.util.Locale;

/** What became of a filament in a frame. */
public enum FrameStatus {

	/** One contour was found. */
	RESOLVED,
	/** The user said what the contour is. */
	CORRECTED,
	/** The filament is there, but no contour can be trusted. */
	UNRESOLVED,
	/** The filament was not found in this frame. */
	LOST,
	/** This filament is not in view in this frame. */
	ABSENT,
	/** The user asked to leave this frame out. */
	IGNORED;

	/** @return the name as written to files: lower case */
	public String label() {
		return name().toLowerCase(Locale.ROOT);
	}
}
