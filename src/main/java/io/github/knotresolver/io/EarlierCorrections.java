package io.github.knotresolver.io;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;

import com.google.gson.JsonArray;
import com.google.gson.JsonElement;
import com.google.gson.JsonObject;
import com.google.gson.JsonParseException;
import com.google.gson.JsonParser;

import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.model.Constraint;
import io.github.knotresolver.model.UserException;

/** What a person said of a result that is in a folder. */
public final class EarlierCorrections {

	private EarlierCorrections() {
	}

	/**
	 * @param folder a result folder
	 * @return what its {@code corrections.csv} says; without one, what its run was told
	 * @throws UserException if the files cannot be read as such, in one sentence
	 */
	public static List<Constraint> of(final Path folder) {
		final Path file = folder.resolve(CorrectionsCsv.FILE);
		return Files.exists(file)
			? CorrectionsCsv.read(file)
			: told(folder.resolve(ParametersJson.FILE));
	}

	private static List<Constraint> told(final Path file) {
		try {
			final JsonObject json = JsonParser
				.parseString(Files.readString(file, StandardCharsets.UTF_8)).getAsJsonObject();
			final List<Constraint> told = new ArrayList<>();
			if (json.has("corrections"))
				json.getAsJsonObject("corrections").asMap().forEach((frame, points) -> told.add(
					Constraint.contour(Integer.parseInt(frame), shape(points.getAsJsonArray()))));
			if (json.has("constraints"))
				json.getAsJsonArray("constraints")
					.forEach(c -> told.add(constraint(c.getAsJsonObject())));
			return Constraint.sorted(told);
		} catch (final IOException | JsonParseException | IllegalStateException | ClassCastException
			| IllegalArgumentException | NullPointerException e) {
			throw new UserException(
				file + " does not tell the corrections of its run; resolve the movie again.", e);
		}
	}

	private static Constraint constraint(final JsonObject json) {
		return new Constraint(json.get("filament").getAsInt(), json.get("frame").getAsInt(),
			Constraint.Kind.valueOf(json.get("kind").getAsString().toUpperCase(Locale.ROOT)),
			shape(json.getAsJsonArray("points")));
	}

	private static Polyline shape(final JsonArray points) {
		final List<Point> shape = new ArrayList<>();
		for (final JsonElement point : points) {
			final double[] xy = Arrays.stream(point.getAsString().split(","))
				.mapToDouble(Double::parseDouble).toArray();
			shape.add(new Point(xy[0], xy[1]));
		}
		return Polyline.of(shape);
	}
}
