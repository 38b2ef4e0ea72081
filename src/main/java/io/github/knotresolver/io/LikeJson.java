package io.github.knotresolver.io;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.Map;

import com.google.gson.FieldNamingPolicy;
import com.google.gson.Gson;
import com.google.gson.GsonBuilder;

import io.github.knotresolver.evaluate.like.LikeMovie;
import io.github.knotresolver.evaluate.like.LikeResult;

/** {@code parameters.json} of a study of movies like a user's. */
public final class LikeJson {

	private static final Gson GSON = new GsonBuilder().setPrettyPrinting().disableHtmlEscaping()
		.setFieldNamingPolicy(FieldNamingPolicy.LOWER_CASE_WITH_UNDERSCORES).create();

	private LikeJson() {
	}

	/**
	 * @param file the file to write
	 * @param result the study
	 * @throws IOException if a file cannot be written
	 */
	public static void write(final Path file, final LikeResult result) throws IOException {
		final Map<String, Object> json = new LinkedHashMap<>();
		json.put("program", ProgramVersion.NAME);
		json.put("version", ProgramVersion.get());
		json.put("like", result.source().movie().name());
		json.put("seed", result.seed());
		json.put("movie_seeds", result.movies().stream().map(LikeMovie::seed).toList());
		json.put("motion", result.motion());
		Files.writeString(file, GSON.toJson(json) + "\n", StandardCharsets.UTF_8);
	}
}
