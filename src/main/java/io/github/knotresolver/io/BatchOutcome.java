package io.github.knotresolver.io;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;

import org.apache.commons.csv.CSVPrinter;

/**
 * What came of one row of a batch.
 *
 * @param row the row
 * @param status what came of it
 * @param folder its result folder, which is there unless the row failed
 * @param message one sentence
 */
public record BatchOutcome(BatchRow row, Status status, Path folder, String message) {

	/** What can come of a row. */
	public enum Status {
		/** Resolved now. */
		FINISHED,
		/** Resolved before. */
		SKIPPED,
		/** There is no result. */
		FAILED
	}

	/** The list of all rows in the folder of a batch. */
	public static final String FILE = "batch.csv";

	/**
	 * Writes one row for every outcome.
	 *
	 * @param file the file to write
	 * @param outcomes what came of the rows
	 * @throws IOException if the disk says no
	 */
	public static void write(final Path file, final List<BatchOutcome> outcomes)
		throws IOException {
		try (
			CSVPrinter csv = CsvFile.create(file, "line", "movie", "status", "result", "message")) {
			for (final BatchOutcome o : outcomes)
				csv.printRecord(o.row().line(), o.row().movie(), o.label(),
					o.status() == Status.FAILED ? "" : o.folder().getFileName(), o.message());
		}
	}

	/** @return the outcome in one line, for people */
	public String line() {
		return row.movie().getFileName() + ": " + label() + ". " + message;
	}

	private String label() {
		return status.name().toLowerCase(Locale.ROOT);
	}
}
