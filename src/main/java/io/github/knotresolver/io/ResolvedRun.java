package io.github.knotresolver.io;

import java.io.IOException;
import java.io.Reader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;

import com.google.gson.JsonElement;
import com.google.gson.JsonObject;
import com.google.gson.JsonParseException;
import com.google.gson.JsonParser;

import io.github.knotresolver.model.UserException;
import io.github.knotresolver.options.RunOptions;

/**
 * A finished result folder, as far as it tells how it was made.
 *
 * @param name the movie's name
 * @param movie the movie's file; empty if the result does not tell it
 * @param options the run's options, so that movies of the same kind can be resolved
 *          alike
 * @param contours the result's contours
 */
public record ResolvedRun(String name, Optional<Path> movie, RunOptions options,
	ContourInput contours) {

	/**
	 * @param folder a folder that {@code resolve} wrote
	 * @return what is in it
	 * @throws UserException if it is no such folder, in one sentence
	 */
	public static ResolvedRun read(final Path folder) {
		final Path json = folder.resolve(ParametersJson.FILE);
		if (!Files.isDirectory(folder) || !ResultFolder.isResult(folder)
			|| !Files.isRegularFile(folder.resolve(ContoursCsv.FILE)))
			throw new UserException("like must be a folder that 'resolve' wrote, with "
				+ ParametersJson.FILE + " and " + ContoursCsv.FILE + ", but is '" + folder + "'.");
		try (Reader reader = Files.newBufferedReader(json, StandardCharsets.UTF_8)) {
			final JsonObject root = JsonParser.parseReader(reader).getAsJsonObject();
			if (!root.has("options") || !root.has("movie"))
				throw new UserException("like must be a folder that 'resolve' wrote, but " + folder
					+ " holds something else; name the folder of a resolved movie.");
			final JsonObject movie = root.getAsJsonObject("movie");
			return new ResolvedRun(movie.get("name").getAsString(),
				text(movie.get("file")).map(Path::of), options(root.getAsJsonObject("options")),
				ContourInput.read(folder));
		} catch (final IOException | JsonParseException | IllegalStateException | ClassCastException
			| IllegalArgumentException | UnsupportedOperationException | NullPointerException e) {
			throw new UserException(json + " is damaged; resolve the movie again.", e);
		}
	}

	private static RunOptions options(final JsonObject given) {
		final Map<String, String> texts = new TreeMap<>();
		for (final String key : RunOptions.KEYS)
			text(given.get(key)).ifPresent(text -> texts.put(key, text));
		return RunOptions.parse(texts);
	}

	private static Optional<String> text(final JsonElement value) {
		return value == null || value.isJsonNull()
			? Optional.empty()
			: Optional.of(value.getAsString());
	}

	/**
	 * @param named a file that the user names; null for the recorded one
	 * @return the movie's file
	 * @throws UserException if it is not there, in one sentence that says
	 *           what to do
	 */
	public Path movieFile(final Path named) {
		if (named != null)
			return named;
		final Path file = movie.orElseThrow(
			() -> new UserException("movie is missing: the result does not tell the file of '"
				+ name + "'; name the movie that it was made from."));
		if (!Files.exists(file))
			throw new UserException("movie is missing: " + file
				+ ", which the result was made from, is gone; name the file where it is now.");
		return file;
	}
}
