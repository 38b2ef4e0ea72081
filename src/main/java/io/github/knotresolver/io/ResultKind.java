package io.github.knotresolver.io;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Optional;
import java.util.Set;
import java.util.regex.Pattern;
import java.util.stream.Collectors;

import com.google.gson.JsonElement;
import com.google.gson.JsonObject;
import com.google.gson.JsonParseException;
import com.google.gson.JsonParser;

import io.github.knotresolver.measure.Quantity;

/**
 * The kinds of folder that this program writes, and the names of the files that
 * each of them may hold. Only files with these names are ever replaced.
 */
public enum ResultKind {

	/** What {@code resolve} and {@code batch} write. */
	RESOLVED_MOVIE("a resolved movie", "options", Names.FIGURES + "|"
		+ "RoiSet\\.zip|overlay\\.(tif|avi|png)|montage(-\\d{2,})?\\.png|MTdata(-\\d{2,})?\\.csv|statsSummary(-\\d{2,})?\\.txt",
		"contours.csv", "frames.csv", "filaments.csv", "summary.csv"),

	/** What {@code measure} writes. */
	MEASUREMENT("measurements", "smoothing_window",
		Names.FIGURES + "|statsSummary(-\\d{2,})?\\.txt", "contours.csv", "frames.csv",
		"filaments.csv", "crossings.csv", "oscillations.csv", "spectra.csv", "waves.csv"),

	/** What {@code simulate} writes. */
	SIMULATION("a simulated movie", "simulation", "", "movie.tif", "contours.csv", "filaments.csv"),

	/** What {@code evaluate --like} writes. */
	STUDY("a study of movies like a result's", "movie_seeds",
		"(position_error|dice|frechet)\\.(png|svg)", "movies.csv", "frames.csv", "resemblance.csv",
		"summary.txt", "comparison.png");

	private final String label;
	private final String key;
	private final Pattern pattern;
	private final Set<String> names;

	/**
	 * @param key what only its {@code parameters.json} has
	 */
	ResultKind(final String label, final String key, final String pattern, final String... names) {
		this.label = label;
		this.key = key;
		this.pattern = Pattern.compile(pattern);
		this.names = Set.of(names);
	}

	/** @return what such a folder holds, in words */
	public String label() {
		return label;
	}

	/**
	 * @param name of a file in the folder
	 * @return whether this program gives files of such a folder that name
	 */
	public boolean owns(final String name) {
		return name.equals(ParametersJson.FILE) || names.contains(name)
			|| pattern.matcher(name).matches();
	}

	/**
	 * @param folder a folder, present or not
	 * @return the kind of the finished result that it holds; empty if it holds none
	 */
	public static Optional<ResultKind> of(final Path folder) {
		final Path file = folder.resolve(ParametersJson.FILE);
		if (!Files.isRegularFile(file))
			return Optional.empty();
		try {
			final JsonElement root = JsonParser
				.parseString(Files.readString(file, StandardCharsets.UTF_8));
			return root.isJsonObject() && isOurs(root.getAsJsonObject())
				? Arrays.stream(values()).filter(k -> root.getAsJsonObject().has(k.key)).findFirst()
				: Optional.empty();
		} catch (final IOException | JsonParseException e) {
			return Optional.empty();
		}
	}

	private static boolean isOurs(final JsonObject json) {
		final JsonElement program = json.get("program");
		return program != null && program.isJsonPrimitive()
			&& program.getAsString().equals(ProgramVersion.NAME);
	}

	/** Names that several kinds have. */
	private static final class Names {

		private static final String QUANTITY = Arrays.stream(Quantity.values()).map(Quantity::key)
			.collect(Collectors.joining("|", "(", ")"));
		private static final String KYMOGRAPH = "(tangent_angle|curvature)_kymograph";
		private static final String FIGURES = "(contours|" + QUANTITY + "(_spectrum)?|" + KYMOGRAPH
			+ ")(-\\d{2,})?\\.(png|svg)|" + KYMOGRAPH + "(-\\d{2,})?\\.tif";
	}
}
