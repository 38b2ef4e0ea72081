package io.github.knotresolver.io;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.stream.Stream;

import io.github.knotresolver.model.UserException;

/** What a batch works on: a sheet, or a folder with one row for every movie in it. */
public final class MovieFolder {

	private static final List<String> ENDINGS = List.of(".tif", ".tiff", ".avi", ".gif", ".zip");

	private MovieFolder() {
	}

	/**
	 * @param input a sheet or a folder
	 * @return the rows; those of a folder in the order of their names
	 * @throws UserException if it is neither, or has no movie; in one
	 *           sentence
	 */
	public static BatchSheet read(final Path input) {
		if (!Files.isDirectory(input))
			return BatchSheet.read(input);
		final List<BatchRow> rows = new ArrayList<>();
		for (final Path movie : movies(input))
			rows.add(new BatchRow(rows.size() + 1, movie.toString(), Map.of(), List.of()));
		if (rows.isEmpty())
			throw new UserException("The folder " + input + " has no movie ("
				+ String.join(", ", ENDINGS) + "); name another one.");
		return new BatchSheet(rows, List.of());
	}

	private static List<Path> movies(final Path folder) {
		try (Stream<Path> files = Files.list(folder)) {
			return files.filter(Files::isRegularFile).filter(MovieFolder::isMovie).sorted()
				.toList();
		} catch (final IOException e) {
			throw new UserException(
				"The folder " + folder + " cannot be read: " + e.getMessage() + ".", e);
		}
	}

	private static boolean isMovie(final Path file) {
		final String name = file.getFileName().toString().toLowerCase(Locale.ROOT);
		return !name.startsWith(".") && ENDINGS.stream().anyMatch(name::endsWith);
	}
}
