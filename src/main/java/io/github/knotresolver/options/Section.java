package io.github.knotresolver.options;

/** What an option is about. */
public enum Section {

	/** What a user knows of it. */
	FILAMENT("What you know about the filament"),

	/** Frames and region. */
	FRAMES("Which frames, and where"),

	/** Image processing. */
	MASK("From frame to mask"),

	/** Candidates, fit and choice. */
	METHOD("How the filament is resolved"),

	/** Calibration. */
	UNITS("Units"),

	/** Files and threads. */
	RUN("The run");

	private final String heading;

	Section(final String heading) {
		this.heading = heading;
	}

	/** @return the heading over the options of this section */
	public String heading() {
		return heading;
	}
}
