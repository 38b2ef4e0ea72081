package io.github.knotresolver.io;

import java.nio.file.Path;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;

import io.github.knotresolver.model.UserException;

/**
 * One row of a batch sheet.
 *
 * @param line 1-based line of the sheet
 * @param movie the movie's file
 * @param texts the row's options by their keys, not yet checked
 * @param notes what the row asks for and this program does otherwise; one
 *          sentence each
 */
public record BatchRow(int line, Path movie, Map<String, String> texts, List<String> notes) {

	public BatchRow {
		texts = Collections.unmodifiableMap(new TreeMap<>(texts));
		notes = List.copyOf(notes);
	}

	/**
	 * @return the row's options
	 * @throws UserException if a value is not allowed
	 */
	public RunOptions options() {
		return RunOptions.parse(texts);
	}
}
