
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

import io.github.knotresolver.simulate.SimulationParameters;

/**
 * {@code parameters.json} of a simulated movie: everything needed to make it
 * again. Units are µm, pN and s, as the parameters' documentation says.
 */
public final class SimulationJson {

	private static final Gson GSON = new GsonBuilder().setPrettyPrinting().disableHtmlEscaping()
		.setFieldNamingPolicy(FieldNamingPolicy.LOWER_CASE_WITH_UNDERSCORES).serializeNulls()
		.serializeSpecialFloatingPointValues().create();

	private SimulationJson() {
	}

	/**
	 * @param file the file to write
	 * @param simulation what decided the trajectory
	 * @param rendering what decided the pictures, by option
	 * @throws IOException if a file cannot be written
	 */
	public static void write(final Path file, final SimulationParameters simulation,
		final Map<String, Object> rendering) throws IOException {
		final Map<String, Object> json = new LinkedHashMap<>();
		json.put("program", ProgramVersion.NAME);
		json.put("version", ProgramVersion.get());
		json.put("simulation", simulation);
		json.put("rendering", rendering);
		Files.writeString(file, GSON.toJson(json) + "\n", StandardCharsets.UTF_8);
	}
}
