
package io.github.knotresolver.io;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.stream.IntStream;

import com.google.gson.Gson;
import com.google.gson.GsonBuilder;
import com.google.gson.JsonObject;

import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.model.Calibration;
import io.github.knotresolver.model.Movie;
import io.github.knotresolver.model.Settings;
import io.github.knotresolver.model.Tracks;

/**
 * {@code parameters.json}: everything needed to repeat a run, with the
 * program's version. The keys under {@code options} are those of
 * {@link RunOptions}. The number of threads is left out: it does not change the
 * result.
 */
public final class ParametersJson {

	/** The file's name in a result folder. */
	public static final String FILE = "parameters.json";

	private static final String PROGRAM = "program";
	private static final Gson GSON = new GsonBuilder().setPrettyPrinting().disableHtmlEscaping()
		.serializeNulls().create();

	private ParametersJson() {
	}

	/**
	 * @param file the file to write
	 * @param tracks the result
	 * @param input how the movie was taken from its image
	 * @param image the image's file; empty if there is none
	 * @throws IOException if the disk says no
	 */
	public static void write(final Path file, final Tracks tracks, final InputOptions input,
		final Optional<Path> image) throws IOException {
		final Map<String, Object> json = new LinkedHashMap<>();
		json.put(PROGRAM, ProgramVersion.NAME);
		json.put("version", ProgramVersion.get());
		json.put("movie", movie(tracks.movie(), image));
		json.put("options", options(tracks, input));
		json.put("corrections", corrections(tracks.settings().corrections()));
		json.put("found", found(tracks));
		json.put("notes", tracks.notes());
		Files.writeString(file, GSON.toJson(json) + "\n", StandardCharsets.UTF_8);
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
		options(tracks, input).forEach((key, value) -> {
			if (value != null)
				line.append(line.isEmpty() ? "" : " ").append(key).append('=').append(value);
		});
		return line.toString();
	}

	/** @return whether this program wrote the file */
	static boolean isOurs(final Path file) {
		try {
			final JsonObject json = GSON.fromJson(Files.readString(file), JsonObject.class);
			return json != null && json.has(PROGRAM)
				&& ProgramVersion.NAME.equals(json.get(PROGRAM).getAsString());
		} catch (final IOException | RuntimeException e) {
			return false;
		}
	}

	private static Map<String, Object> movie(final Movie movie, final Optional<Path> image) {
		final Map<String, Object> json = new LinkedHashMap<>();
		json.put("name", movie.name());
		json.put("width", movie.width());
		json.put("height", movie.height());
		json.put("frames", movie.size());
		json.put("unit", movie.calibration().unit());
		json.put("time_unit", movie.calibration().timeUnit());
		json.put("file", image.map(Path::toString).orElse(null));
		return json;
	}

	private static Map<String, Object> options(final Tracks tracks,
		final InputOptions input) {
		final Settings p = tracks.settings();
		final Calibration c = tracks.movie().calibration();
		final Map<String, Object> json = new LinkedHashMap<>();
		json.put("fixed_end", p.fixedEnd().map(Point::toString).orElse(null));
		json.put("region", p.region().map(Object::toString).orElse(null));
		json.put("threshold",
			p.segmentation().threshold().isPresent()
				? p.segmentation().threshold().getAsDouble()
				: "otsu");
		json.put("iterations", p.segmentation().iterations());
		json.put("contraction_bias", p.segmentation().contractionBias());
		json.put("smooth_factor", p.segmentation().smoothFactor());
		json.put("segmentation", label(p.segmentation().steps()));
		json.put("log_size", p.cleaning().enhances() ? p.cleaning().logSize() : null);
		json.put("log_sigma", p.cleaning().enhances() ? p.cleaning().logSigma() : null);
		json.put("candidates", label(p.candidates()));
		json.put("resolver", label(p.resolver()));
		json.put("length",
			p.length().isPresent() ? p.length().getAsDouble() * c.pixelSize() : null);
		json.put("length_model", label(p.lengthModel()));
		json.put("refine", p.refine());
		json.put("channel", input.channel());
		json.put("z_as_time", input.zAsTime());
		json.put("frames", p.frames().isEmpty() ? null : FrameSelection.format(p.frames()));
		json.put("ignore_frames",
			p.ignoreFrames().isEmpty() ? null : FrameSelection.format(p.ignoreFrames()));
		json.put("pixel_size", c.hasLengthUnit() ? c.pixelSize() : null);
		json.put("unit", c.hasLengthUnit() ? c.unit() : null);
		json.put("frame_interval", c.hasTimeUnit() ? c.frameInterval() : null);
		return json;
	}

	private static Map<String, Object> found(final Tracks tracks) {
		final double pixelSize = tracks.movie().calibration().pixelSize();
		final Map<String, Object> json = new LinkedHashMap<>();
		json.put("fixed_end", tracks.only().fixedEnd()
			.map(p -> NumberText.pixels(p.x()) + "," + NumberText.pixels(p.y())).orElse(null));
		json.put("length", finite(tracks.only().length() * pixelSize));
		json.put("length_uncertainty", finite(tracks.only().lengthError() * pixelSize));
		json.put("resolved_frames", tracks.resolved());
		return json;
	}

	private static Map<String, List<String>> corrections(final Map<Integer, Polyline> contours) {
		final Map<String, List<String>> json = new LinkedHashMap<>();
		new TreeMap<>(contours).forEach((frame, contour) -> json.put(frame.toString(), IntStream
			.range(0, contour.size()).mapToObj(i -> contour.point(i).toString()).toList()));
		return json;
	}

	private static Double finite(final double value) {
		return Double.isFinite(value) ? Double.valueOf(NumberText.significant(value)) : null;
	}

	private static String label(final Enum<?> constant) {
		return constant.name().toLowerCase(Locale.ROOT);
	}
}
