package io.github.knotresolver.io;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.regex.Pattern;
import java.util.stream.Stream;

import io.github.knotresolver.model.UserException;

/**
 * What a batch works on: a sheet, or a folder with one row for every movie in it. A
 * folder in it that holds numbered pictures, one a frame, is a movie, too.
 */
public final class MovieFolder {

	private static final List<String> ENDINGS = List.of(".tif", ".tiff", ".tf8", ".btf", ".stk",
		".lsm", ".avi", ".gif", ".zip");
	private static final Pattern NUMBERED = Pattern.compile("[^.].*\\d\\.(png|jpe?g|bmp|pgm)",
		Pattern.CASE_INSENSITIVE);
	private static final int FEWEST_FRAMES = 3;

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
			throw new UserException(
				"The folder " + input + " has no movie (" + String.join(", ", ENDINGS)
					+ "), and no folder of numbered pictures; name another one.");
		return new BatchSheet(rows, List.of());
	}

	private static List<Path> movies(final Path folder) {
		try (Stream<Path> files = Files.list(folder)) {
			return files.filter(
				f -> Files.isDirectory(f) ? isSequence(f) : Files.isRegularFile(f) && isMovie(f))
				.sorted().toList();
		} catch (final IOException e) {
			throw new UserException(
				"The folder " + folder + " cannot be read: " + e.getMessage() + ".", e);
		}
	}

	/** Pictures of a result are no movie. */
	private static boolean isSequence(final Path folder) {
		if (folder.getFileName().toString().startsWith(".") || ResultKind.of(folder).isPresent())
			return false;
		try (Stream<Path> files = Files.list(folder)) {
			return files.filter(f -> NUMBERED.matcher(f.getFileName().toString()).matches())
				.limit(FEWEST_FRAMES).count() == FEWEST_FRAMES;
		} catch (final IOException e) {
			// A folder that may not be read is none of the movies.
			return false;
		}
	}

	private static boolean isMovie(final Path file) {
		final String name = file.getFileName().toString().toLowerCase(Locale.ROOT);
		return !name.startsWith(".") && ENDINGS.stream().anyMatch(name::endsWith);
	}
}
