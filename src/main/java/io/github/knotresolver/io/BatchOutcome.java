package io.github.knotresolver.io;

import java.util.Locale;
import java.util.Optional;

/**
 * What came of one row of a batch.
 *
 * @param row the row
 * @param status what came of it
 * @param folder the name of its result folder; present unless the row failed
 * @param message one sentence
 */
public record BatchOutcome(BatchRow row, Status status, Optional<String> folder, String message) {

	/** What can come of a row. */
	public enum Status {
		/** Resolved now. */
		FINISHED,
		/** Resolved before. */
		SKIPPED,
		/** There is no result. */
		FAILED
	}

	/**
	 * @param row a row
	 * @param message why there is no result, one sentence
	 * @return the outcome
	 */
	public static BatchOutcome failed(final BatchRow row, final String message) {
		return new BatchOutcome(row, Status.FAILED, Optional.empty(), message);
	}

	/**
	 * @param row a row whose result is there already
	 * @param folder the name of its folder
	 * @return the outcome
	 */
	public static BatchOutcome skipped(final BatchRow row, final String folder) {
		return new BatchOutcome(row, Status.SKIPPED, Optional.of(folder),
			"The same movie was resolved with these options before, in folder " + folder
				+ "; add force to do it again.");
	}

	/** @return the outcome in one line, for people */
	public String line() {
		return row.name() + ": " + label() + ". " + message;
	}

	/** @return the status, in a word */
	public String label() {
		return status.name().toLowerCase(Locale.ROOT);
	}
}
