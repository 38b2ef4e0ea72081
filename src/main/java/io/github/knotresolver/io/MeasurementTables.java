package io.github.knotresolver.io;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.EnumSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;

import com.google.gson.GsonBuilder;

import org.apache.commons.csv.CSVPrinter;

import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.measure.ContourGeometry;
import io.github.knotresolver.measure.DominantFrequency;
import io.github.knotresolver.measure.FrameMeasurement;
import io.github.knotresolver.measure.Kymograph;
import io.github.knotresolver.measure.MovieMeasurements;
import io.github.knotresolver.measure.Quantity;
import io.github.knotresolver.measure.Spectrum;
import io.github.knotresolver.measure.TravellingWave;

/**
 * Measurements as tidy tables: {@code contours.csv} has one row a point of
 * the smoothed contour,
 * {@code frames.csv} one row a frame, {@code crossings.csv} one row a crossing,
 * {@code oscillations.csv} one row a quantity, {@code spectra.csv} one row a
 * quantity and frequency, {@code waves.csv} one row a field; {@code parameters.json} holds what they were made with. Columns that
 * end in {@code _se} are standard errors; the last one, {@code filament}, is the
 * filament's number; what is missing is empty.
 */
public final class MeasurementTables {

	/** The quantities whose oscillation is looked for, besides those whose spectra are wanted. */
	private static final List<Quantity> OSCILLATING = List.of(Quantity.TIP_ANGLE,
		Quantity.END_TO_END, Quantity.BENDING_ENERGY);

	/** Writes the rows of one filament. */
	@FunctionalInterface
	private interface Rows {

		void write(Sheet table, MovieMeasurements movie) throws IOException;
	}

	/** A table whose rows end with the filament's number. */
	private record Sheet(CSVPrinter csv, int filament) {

		void print(final Object... cells) throws IOException {
			print(List.of(cells));
		}

		void print(final List<Object> cells) throws IOException {
			final List<Object> row = new ArrayList<>(cells);
			row.add(filament);
			csv.printRecord(row);
		}
	}

	private final List<FilamentMeasurements> filaments;

	/** @param filaments the measurements of every filament, at least one */
	public MeasurementTables(final List<FilamentMeasurements> filaments) {
		this.filaments = List.copyOf(filaments);
	}

	/**
	 * Writes all tables.
	 *
	 * @param folder an existing folder
	 * @throws IOException if a file cannot be written
	 */
	public void write(final Path folder) throws IOException {
		writePoints(folder.resolve(ContoursCsv.FILE));
		writeFrames(folder.resolve(FramesCsv.FILE));
		writeCrossings(folder.resolve("crossings.csv"));
		writeOscillations(folder.resolve("oscillations.csv"));
		writeSpectra(folder.resolve("spectra.csv"));
		writeWaves(folder.resolve("waves.csv"));
		writeParameters(folder.resolve(ParametersJson.FILE));
	}

	private void write(final Path file, final List<String> header, final Rows rows)
		throws IOException {
		final List<String> all = new ArrayList<>(header);
		all.add(ContoursCsv.FILAMENT);
		try (CSVPrinter csv = CsvFile.create(file, all.toArray(String[]::new))) {
			for (final FilamentMeasurements f : filaments)
				rows.write(new Sheet(csv, f.filament()), f.measurements());
		}
	}

	private void writePoints(final Path file) throws IOException {
		write(file, List.of("frame", "index", "x_px", "y_px", "x", "y", "arc_length",
			"tangent_angle", "tangent_angle_se", "curvature", "curvature_se", "unit"),
			(table, movie) -> {
				for (final FrameMeasurement f : movie.measured())
					writePoints(table, movie, f);
			});
	}

	private static void writePoints(final Sheet table, final MovieMeasurements movie,
		final FrameMeasurement f) throws IOException {
		final ContourGeometry g = f.geometry().orElseThrow();
		final Polyline smooth = g.smoothedPx();
		final double[][] columns = {g.x(), g.y(), g.arcLength(), f.tangentAngle(),
			g.noise().tangentAngle(), g.curvature(), g.noise().curvature()};
		for (int i = 0; i < g.size(); i++) {
			final List<Object> row = new ArrayList<>(List.of(f.frame(), i,
				NumberText.pixels(smooth.x(i)), NumberText.pixels(smooth.y(i))));
			for (final double[] column : columns)
				row.add(NumberText.significant(column[i]));
			row.add(movie.calibration().unit());
			table.print(row);
		}
	}

	private void writeFrames(final Path file) throws IOException {
		final List<String> header = new ArrayList<>(List.of("frame", "time"));
		for (final Quantity q : Quantity.values()) {
			header.add(q.key());
			if (q != Quantity.CROSSINGS)
				header.add(q.key() + "_se");
		}
		header.addAll(List.of("unit", "energy_unit", "time_unit"));
		write(file, header, (table, movie) -> {
			final double[] time = movie.times();
			for (final FrameMeasurement f : movie.frames()) {
				final List<Object> row = new ArrayList<>(
					List.of(f.frame(), NumberText.significant(time[f.frame() - 1])));
				for (final Quantity q : Quantity.values()) {
					row.add(NumberText.significant(f.get(q).value()));
					if (q != Quantity.CROSSINGS)
						row.add(NumberText.significant(f.get(q).standardError()));
				}
				row.addAll(List.of(movie.calibration().unit(), movie.unit(Quantity.BENDING_ENERGY),
					movie.calibration().timeUnit()));
				table.print(row);
			}
		});
	}

	private void writeCrossings(final Path file) throws IOException {
		write(file, List.of("frame", "x_px", "y_px"), (table, movie) -> {
			for (final FrameMeasurement f : movie.frames())
				for (final Point p : f.crossings())
					table.print(f.frame(), NumberText.pixels(p.x()), NumberText.pixels(p.y()));
		});
	}

	private void writeOscillations(final Path file) throws IOException {
		write(file,
			List.of("quantity", "dominant_frequency", "dominant_frequency_se", "frequency_unit",
				"amplitude", "amplitude_unit", "phase", "false_alarm_probability"),
			(table, movie) -> {
				for (final Quantity q : oscillating(movie)) {
					final Optional<DominantFrequency> d = movie.dominantFrequency(q);
					if (d.isPresent())
						table.print(q.key(), NumberText.significant(d.get().frequency()),
							NumberText.significant(d.get().standardError()),
							movie.calibration().frequencyUnit(),
							NumberText.significant(d.get().amplitude()), movie.unit(q),
							NumberText.significant(d.get().phase()),
							NumberText.significant(d.get().falseAlarmProbability()));
				}
			});
	}

	private static Set<Quantity> oscillating(final MovieMeasurements movie) {
		final Set<Quantity> all = EnumSet.copyOf(OSCILLATING);
		all.addAll(movie.spectra());
		return all;
	}

	/** Quantities of which too few frames are known have no spectrum. */
	private void writeSpectra(final Path file) throws IOException {
		write(file,
			List.of("quantity", "frequency", "amplitude", "frequency_unit", "amplitude_unit"),
			(table, movie) -> {
				for (final Quantity q : movie.spectra()) {
					final Spectrum spectrum = movie.spectrum(q);
					final double[] f = spectrum.frequency(), a = spectrum.amplitude();
					for (int i = 0; i < f.length; i++)
						table.print(q.key(), NumberText.significant(f[i]),
							NumberText.significant(a[i]), movie.calibration().frequencyUnit(),
							movie.unit(q));
				}
			});
	}

	private void writeWaves(final Path file) throws IOException {
		write(file, List.of("field", "frequency", "frequency_unit", "speed", "speed_se",
			"speed_unit", "wavelength", "amplitude", "place", "coherence", "unit"),
			(table, movie) -> {
				final Map<String, Kymograph> fields = new LinkedHashMap<>();
				fields.put("tangent_angle", movie.tangentAngleKymograph());
				fields.put("curvature", movie.curvatureKymograph());
				for (final Map.Entry<String, Kymograph> field : fields.entrySet()) {
					final Optional<TravellingWave> wave = TravellingWave.of(field.getValue());
					if (wave.isPresent())
						table.print(row(movie, field.getKey(), wave.get()));
				}
			});
	}

	private static List<Object> row(final MovieMeasurements movie, final String field,
		final TravellingWave w) {
		final String unit = movie.calibration().unit();
		return List.of(field, NumberText.significant(w.frequency()),
			movie.calibration().frequencyUnit(), NumberText.significant(w.speed()),
			NumberText.significant(w.speedError()), unit + "/" + movie.calibration().timeUnit(),
			NumberText.significant(w.wavelength()), NumberText.significant(w.amplitude()),
			NumberText.significant(w.place()), NumberText.significant(w.coherence()), unit);
	}

	/** Figures that each filament has for itself are those of the first, and stand in a list for all. */
	private void writeParameters(final Path file) throws IOException {
		final MovieMeasurements movie = filaments.get(0).measurements();
		final Map<String, Object> json = new LinkedHashMap<>();
		json.put("program", ProgramVersion.NAME);
		json.put("version", ProgramVersion.get());
		json.put("contours", movie.name());
		json.put("frames", movie.frames().size());
		json.put("measured_frames", movie.measured().size());
		json.put("smoothing_window",
			Double.valueOf(NumberText.significant(movie.smoothing().window())));
		json.put("smoothing_order", movie.smoothing().order());
		json.put("rigidity", movie.rigidity().kind().name().toLowerCase(Locale.ROOT));
		json.put("rigidity_value", movie.rigidity().value());
		json.put("pixel_size", movie.calibration().pixelSize());
		json.put("unit", movie.calibration().unit());
		json.put("frame_interval", movie.calibration().frameInterval());
		json.put("time_unit", movie.calibration().timeUnit());
		json.put("filaments", filaments.stream().map(MeasurementTables::parameters).toList());
		Files.writeString(file,
			new GsonBuilder().setPrettyPrinting().disableHtmlEscaping().create().toJson(json)
				+ "\n",
			StandardCharsets.UTF_8);
	}

	private static Map<String, Object> parameters(final FilamentMeasurements f) {
		final Map<String, Object> json = new LinkedHashMap<>();
		json.put(ContoursCsv.FILAMENT, f.filament());
		json.put("measured_frames", f.measurements().measured().size());
		json.put("smoothing_window",
			Double.valueOf(NumberText.significant(f.measurements().smoothing().window())));
		return json;
	}
}
