package io.github.knotresolver.io;

import java.nio.file.Path;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;

import io.github.knotresolver.model.UserException;
import io.github.knotresolver.options.RunOptions;

/**
 * One row of a batch sheet.
 *
 * @param line 1-based line of the sheet
 * @param movie the movie's file
 * @param texts the row's options by their keys, not yet checked
 * @param notes what the row asks for and this program does otherwise; one
 *          sentence each
 * @param refusal why the row cannot be done, in one sentence; empty if it can be tried
 */
public record BatchRow(int line, Path movie, Map<String, String> texts, List<String> notes,
	Optional<String> refusal) {

	public BatchRow {
		texts = Collections.unmodifiableMap(new TreeMap<>(texts));
		notes = List.copyOf(notes);
	}

	/** A row that can be tried. */
	public BatchRow(final int line, final Path movie, final Map<String, String> texts,
		final List<String> notes) {
		this(line, movie, texts, notes, Optional.empty());
	}

	/** A row that cannot. */
	static BatchRow refused(final int line, final Path movie, final String sentence) {
		return new BatchRow(line, movie, Map.of(), List.of(), Optional.of(sentence));
	}

	/** @throws UserException if the row cannot be done */
	public void requireTryable() {
		refusal.ifPresent(sentence -> {
			throw new UserException(sentence);
		});
	}

	/**
	 * @return the row's options
	 * @throws UserException if a value is not allowed
	 */
	public RunOptions options() {
		return RunOptions.parse(texts);
	}
}
