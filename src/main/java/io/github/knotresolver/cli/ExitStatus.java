package io.github.knotresolver.cli;

/** What the process's exit status says. */
public final class ExitStatus {

	/** Finished; frames that could not be resolved are in the report. */
	public static final int FINISHED = 0;
	/** The input was fine, but there is no result. */
	public static final int FAILED = 1;
	/** Wrong usage or unreadable input. */
	public static final int USAGE = 2;
	/** The user stopped it. */
	public static final int CANCELLED = 130;

	private ExitStatus() {
	}
}
