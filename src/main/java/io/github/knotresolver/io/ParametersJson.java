
package io.github.knotresolver.io;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.stream.IntStream;
import java.util.stream.Stream;

import com.google.gson.FieldNamingPolicy;
import com.google.gson.Gson;
import com.google.gson.GsonBuilder;

import io.github.knotresolver.evaluate.like.LikeResult;
import io.github.knotresolver.evaluate.like.LikeResult.LikeMovie;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.model.Constraint;
import io.github.knotresolver.model.FilamentTrack;
import io.github.knotresolver.model.Movie;
import io.github.knotresolver.model.Settings;
import io.github.knotresolver.model.Tracks;
import io.github.knotresolver.options.InputOptions;
import io.github.knotresolver.options.RunOptions;
import io.github.knotresolver.simulate.SimulationParameters;

/**
 * {@code parameters.json}: everything needed to repeat a run, with the
 * program's version. The keys under {@code options} are those of
 * {@link RunOptions}. The number of threads is left out: it does not change the
 * result.
 */
public final class ParametersJson {

	/** The file's name in a result folder. */
	public static final String FILE = "parameters.json";

	private static final Gson GSON = new GsonBuilder().setPrettyPrinting().disableHtmlEscaping()
		.serializeNulls().create();

	/** Of records: their fields by their names. */
	private static final Gson FIELDS = new GsonBuilder().setPrettyPrinting().disableHtmlEscaping()
		.setFieldNamingPolicy(FieldNamingPolicy.LOWER_CASE_WITH_UNDERSCORES).serializeNulls()
		.serializeSpecialFloatingPointValues().create();

	private ParametersJson() {
	}

	/**
	 * @param file the file to write
	 * @param tracks the result
	 * @param input how the movie was taken from its image
	 * @param identity what it was made from; empty if the image has no file
	 * @param notes what else a user should know; one sentence each
	 * @throws IOException if a file cannot be written
	 */
	public static void write(final Path file, final Tracks tracks, final InputOptions input,
		final Optional<RunIdentity> identity, final List<String> notes) throws IOException {
		final Map<String, Object> json = program();
		json.put("movie", movie(tracks.movie(), identity));
		json.put("options",
			RunOptions.values(tracks.settings(), input, tracks.movie().calibration()));
		json.put("corrections", corrections(tracks.settings().corrections()));
		json.put("constraints", constraints(tracks.settings()));
		identity.ifPresent(i -> {
			json.put(RunIdentity.GIVEN, i.given());
			json.put(RunIdentity.CORRECTIONS, i.corrections());
		});
		json.put("found", found(tracks));
		json.put("notes", Stream.concat(tracks.notes().stream(), notes.stream()).toList());
		write(file, GSON, json);
	}

	/**
	 * Of a study of movies like a user's.
	 *
	 * @param file the file to write
	 * @param result the study
	 * @throws IOException if a file cannot be written
	 */
	public static void write(final Path file, final LikeResult result) throws IOException {
		final Map<String, Object> json = program();
		json.put("like", result.source().movie().name());
		json.put("seed", result.seed());
		json.put("movie_seeds", result.movies().stream().map(LikeMovie::seed).toList());
		json.put("motion", result.motion());
		write(file, FIELDS, json);
	}

	/**
	 * Of a simulated movie: everything needed to make it again. Units are µm, pN and s, as the
	 * parameters' documentation says.
	 *
	 * @param file the file to write
	 * @param simulation what decided the trajectory
	 * @param rendering what decided the pictures, by option
	 * @throws IOException if a file cannot be written
	 */
	public static void write(final Path file, final SimulationParameters simulation,
		final Map<String, Object> rendering) throws IOException {
		final Map<String, Object> json = program();
		json.put("simulation", simulation);
		json.put("rendering", rendering);
		write(file, FIELDS, json);
	}

	private static Map<String, Object> program() {
		final Map<String, Object> json = new LinkedHashMap<>();
		json.put("program", ProgramVersion.NAME);
		json.put("version", ProgramVersion.get());
		return json;
	}

	private static void write(final Path file, final Gson gson, final Map<String, Object> json)
		throws IOException {
		Files.writeString(file, gson.toJson(json) + "\n", StandardCharsets.UTF_8);
	}

	/**
	 * The options of a run on one line, as a macro has them.
	 *
	 * @param tracks the result
	 * @param input how the movie was taken from its image
	 * @return {@code key=value} of every option that has a value
	 */
	public static String line(final Tracks tracks, final InputOptions input) {
		final StringBuilder line = new StringBuilder();
		RunOptions.values(tracks.settings(), input, tracks.movie().calibration())
			.forEach((key, value) -> {
				if (value != null)
					line.append(line.isEmpty() ? "" : " ").append(key).append('=').append(value);
			});
		return line.toString();
	}

	private static Map<String, Object> movie(final Movie movie,
		final Optional<RunIdentity> identity) {
		final Map<String, Object> json = new LinkedHashMap<>();
		json.put("name", movie.name());
		json.put("width", movie.width());
		json.put("height", movie.height());
		json.put("frames", movie.size());
		json.put("unit", movie.calibration().unit());
		json.put("time_unit", movie.calibration().timeUnit());
		json.put("file", identity.map(i -> i.movie().toString()).orElse(null));
		json.put(RunIdentity.SHA256, identity.map(RunIdentity::sha256).orElse(null));
		return json;
	}

	private static Map<String, Object> found(final Tracks tracks) {
		final double pixelSize = tracks.movie().calibration().pixelSize();
		final Map<String, Object> json = new LinkedHashMap<>();
		if (tracks.filaments().size() == 1)
			put(json, tracks.filaments().get(0), pixelSize);
		json.put("resolved_frames", tracks.resolved());
		json.put("filaments", tracks.filaments().stream().map(f -> {
			final Map<String, Object> one = new LinkedHashMap<>();
			one.put("filament", f.id());
			one.put("anchor", f.anchor().label());
			put(one, f, pixelSize);
			one.put("resolved_frames", f.resolved());
			return one;
		}).toList());
		return json;
	}

	private static void put(final Map<String, Object> json, final FilamentTrack filament,
		final double pixelSize) {
		json.put("fixed_end", filament.fixedEnd()
			.map(p -> NumberText.pixels(p.x()) + "," + NumberText.pixels(p.y())).orElse(null));
		json.put("length", finite(filament.length() * pixelSize));
		json.put("length_uncertainty", finite(filament.lengthError() * pixelSize));
	}

	private static Map<String, List<String>> corrections(final Map<Integer, Polyline> contours) {
		final Map<String, List<String>> json = new LinkedHashMap<>();
		new TreeMap<>(contours).forEach((frame, contour) -> json.put(frame.toString(), IntStream
			.range(0, contour.size()).mapToObj(i -> contour.point(i).toString()).toList()));
		return json;
	}

	/** What the user said other than whole contours of the first filament. */
	private static List<Map<String, Object>> constraints(final Settings settings) {
		final List<Map<String, Object>> json = new ArrayList<>();
		for (final Constraint c : settings.constraints())
			if (c.kind() != Constraint.Kind.CONTOUR || c.filament() != 1) {
				final Map<String, Object> one = new LinkedHashMap<>();
				one.put("filament", c.filament());
				one.put("frame", c.frame());
				one.put("kind", c.kind().label());
				one.put("points", IntStream.range(0, c.shape().size())
					.mapToObj(i -> c.shape().point(i).toString()).toList());
				json.add(one);
			}
		return json;
	}

	private static Double finite(final double value) {
		return Double.isFinite(value) ? Double.valueOf(NumberText.significant(value)) : null;
	}
}
