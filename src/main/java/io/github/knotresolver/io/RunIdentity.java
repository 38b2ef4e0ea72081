package io.github.knotresolver.io;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.ArrayList;
import java.util.Collections;
import java.util.HexFormat;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;

import com.google.gson.JsonElement;
import com.google.gson.JsonObject;
import com.google.gson.JsonParseException;
import com.google.gson.JsonParser;

import io.github.knotresolver.model.UserException;
import io.github.knotresolver.options.OptionText;
import io.github.knotresolver.options.RunOptions;
import io.github.knotresolver.progress.Progress;

/**
 * What a result was made from, so that it is known again: the movie's file and
 * its contents, the options that were given, and the program's version.
 *
 * @param movie the movie's file, absolute
 * @param sha256 the SHA-256 of its bytes, in hexadecimal digits
 * @param version the program's version
 * @param given the options that were given, by key; not those that leave the
 *          result as it is
 * @param corrections the SHA-256 of the file of corrections; empty without one
 */
public record RunIdentity(Path movie, String sha256, String version, Map<String, String> given,
	String corrections) {

	/** The keys in {@code parameters.json}. */
	static final String SHA256 = "sha256", GIVEN = "given", CORRECTIONS = "corrections_sha256";

	private static final String CORRECTIONS_KEY = "corrections";
	private static final String THREADS_KEY = "threads";
	private static final int BUFFER = 1 << 16;

	public RunIdentity {
		given = Collections.unmodifiableMap(new TreeMap<>(given));
	}

	/**
	 * @param movie the movie's file
	 * @param texts the options that were given, by key
	 * @param progress may cancel
	 * @return what a result of them is made from
	 * @throws UserException if the name of the corrections cannot be that of a file
	 * @throws IOException if the files cannot be read
	 */
	public static RunIdentity of(final Path movie, final Map<String, String> texts,
		final Progress progress) throws IOException {
		final Map<String, String> given = new TreeMap<>(texts);
		given.values().removeIf(text -> text == null || text.isBlank());
		given.remove(THREADS_KEY);
		final String corrections = given.remove(CORRECTIONS_KEY);
		return new RunIdentity(movie.toAbsolutePath().normalize(), sha256(movie, progress),
			ProgramVersion.get(), given,
			corrections == null
				? ""
				: sha256(OptionText.path(CORRECTIONS_KEY, corrections), progress));
	}

	/**
	 * @param movie the movie's file; empty if it has none
	 * @param texts the options that were given, by key
	 * @param progress may cancel
	 * @return what a result of them is made from; empty without a file
	 * @throws IOException if the files cannot be read
	 */
	public static Optional<RunIdentity> of(final Optional<Path> movie,
		final Map<String, String> texts, final Progress progress) throws IOException {
		return movie.isPresent() ? Optional.of(of(movie.get(), texts, progress)) : Optional.empty();
	}

	/**
	 * @param movie the movie's file; empty if it has none
	 * @param texts the options that were given, by key
	 * @return all files that are read
	 * @throws UserException if the name of one cannot be that of a file
	 */
	public static List<Path> files(final Optional<Path> movie, final Map<String, String> texts) {
		final List<Path> files = new ArrayList<>(movie.stream().toList());
		final String corrections = texts.get(CORRECTIONS_KEY);
		if (corrections != null && !corrections.isBlank())
			files.add(OptionText.path(CORRECTIONS_KEY, corrections));
		return files;
	}

	/**
	 * @param folder a result folder
	 * @return what its result was made from; empty if it does not tell
	 */
	public static Optional<RunIdentity> read(final Path folder) {
		if (ResultKind.of(folder).filter(k -> k == ResultKind.RESOLVED_MOVIE).isEmpty())
			return Optional.empty();
		try {
			final JsonObject json = JsonParser
				.parseString(
					Files.readString(folder.resolve(ParametersJson.FILE), StandardCharsets.UTF_8))
				.getAsJsonObject();
			final JsonObject movie = json.getAsJsonObject("movie");
			if (movie == null || isMissing(movie.get("file")))
				return Optional.empty();
			final Map<String, String> given = new TreeMap<>();
			if (json.has(GIVEN))
				json.getAsJsonObject(GIVEN).asMap()
					.forEach((key, value) -> given.put(key, value.getAsString()));
			return Optional.of(
				new RunIdentity(Path.of(movie.get("file").getAsString()), text(movie.get(SHA256)),
					text(json.get("version")), given, text(json.get(CORRECTIONS))));
		} catch (final IOException | JsonParseException | IllegalStateException | ClassCastException
			| UnsupportedOperationException | InvalidPathException e) {
			return Optional.empty();
		}
	}

	private static boolean isMissing(final JsonElement element) {
		return element == null || element.isJsonNull();
	}

	private static String text(final JsonElement element) {
		return isMissing(element) ? "" : element.getAsString();
	}

	/**
	 * @param other another result
	 * @return whether it is the same, however the options were written
	 */
	public boolean isSame(final RunIdentity other) {
		return movie.equals(other.movie) && !sha256.isEmpty() && sha256.equals(other.sha256)
			&& version.equals(other.version) && corrections.equals(other.corrections)
			&& sameOptions(other);
	}

	/**
	 * Compares without reading a file.
	 *
	 * @param file a movie's file, absolute
	 * @param texts the options that were given, by key
	 * @return whether this is a result of that path with these options, by this version, whatever the
	 *         contents of the files
	 */
	boolean isOf(final Path file, final Map<String, String> texts) {
		final Map<String, String> options = new TreeMap<>(texts);
		options.values().removeIf(text -> text == null || text.isBlank());
		options.keySet().removeAll(List.of(THREADS_KEY, CORRECTIONS_KEY));
		return movie.equals(file) && version.equals(ProgramVersion.get())
			&& sameOptions(new RunIdentity(file, sha256, version, options, corrections));
	}

	private boolean sameOptions(final RunIdentity other) {
		try {
			return RunOptions.parse(given).equals(RunOptions.parse(other.given));
		} catch (final UserException e) {
			// Options of another version; the row's own are checked when it has its turn.
			return false;
		}
	}

	/** Of a folder of images, that of the names and contents of all files in it. */
	private static String sha256(final Path path, final Progress progress) throws IOException {
		try {
			final MessageDigest digest = MessageDigest.getInstance("SHA-256");
			if (Files.isDirectory(path))
				for (final String name : FileTrees.names(path)) {
					if (!Files.isRegularFile(path.resolve(name)))
						continue;
					digest.update(name.getBytes(StandardCharsets.UTF_8));
					update(digest, path.resolve(name), progress);
				}
			else
				update(digest, path, progress);
			return HexFormat.of().formatHex(digest.digest());
		} catch (final NoSuchAlgorithmException e) {
			throw new IllegalStateException(e);
		}
	}

	private static void update(final MessageDigest digest, final Path file, final Progress progress)
		throws IOException {
		try (InputStream in = Files.newInputStream(file)) {
			final byte[] buffer = new byte[BUFFER];
			for (int n = in.read(buffer); n >= 0; n = in.read(buffer)) {
				digest.update(buffer, 0, n);
				progress.checkCancelled();
			}
		}
	}
}
