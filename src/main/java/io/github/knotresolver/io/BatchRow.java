package io.github.knotresolver.io;

import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;

import io.github.knotresolver.model.UserException;
import io.github.knotresolver.options.RunOptions;

/**
 * One row of a batch sheet.
 *
 * @param line 1-based line of the sheet
 * @param movie the movie's file, as text: not all text is a path on every system
 * @param texts the row's options by their keys, not yet checked
 * @param byHand whether the row asks for work by hand
 * @param notes what the row asks for and this program does otherwise; one
 *          sentence each
 */
public record BatchRow(int line, String movie, Map<String, String> texts, boolean byHand,
	List<String> notes) {

	public BatchRow {
		texts = Collections.unmodifiableMap(new TreeMap<>(texts));
		notes = List.copyOf(notes);
	}

	/**
	 * A row that asks for nothing by hand.
	 *
	 * @param line 1-based line of the sheet
	 * @param movie the movie's file, as text
	 * @param texts the row's options by their keys, not yet checked
	 * @param notes what the row asks for and this program does otherwise
	 */
	public BatchRow(final int line, final String movie, final Map<String, String> texts,
		final List<String> notes) {
		this(line, movie, texts, false, notes);
	}

	/**
	 * @return the movie's file
	 * @throws UserException if no file can have that name here, in one
	 *           sentence
	 */
	public Path file() {
		try {
			return Path.of(movie);
		} catch (final InvalidPathException e) {
			throw new UserException(
				"'" + visible(movie) + "' cannot be the name of a file on this system ("
					+ e.getReason() + ", names are in " + System.getProperty("sun.jnu.encoding")
					+ "); write it otherwise, or set LC_ALL=C.UTF-8 if it has letters like ü.",
				e);
		}
	}

	/** @return the movie's file name, without the folders */
	public String name() {
		return visible(
			movie.substring(Math.max(movie.lastIndexOf('/'), movie.lastIndexOf('\\')) + 1));
	}

	/** @return the movie's file as a list or a person can be shown it */
	String shown() {
		return visible(movie);
	}

	/** Text of a sheet may hold characters that no terminal shows. */
	private static String visible(final String text) {
		return text.replaceAll("\\p{Cntrl}", "\uFFFD");
	}

	/**
	 * @param defaults options of all rows, by key
	 * @return the row's own options over them
	 */
	public Map<String, String> over(final Map<String, String> defaults) {
		final Map<String, String> all = new TreeMap<>(defaults);
		all.putAll(texts);
		return all;
	}

	/**
	 * @return the row's options
	 * @throws UserException if a value is not allowed
	 */
	public RunOptions options() {
		return RunOptions.parse(texts);
	}
}
