package io.github.knotresolver.options;

/** What an option is about. */
public enum Section {

	FILAMENT("What you know about the filament"),

	FRAMES("Which frames, and where"),

	MASK("From frame to mask"),

	METHOD("How the filament is resolved"),

	UNITS("Units"),

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
