package io.github.knotresolver.io;

import java.io.IOException;
import java.nio.file.Path;
import java.util.function.ToDoubleFunction;

import org.apache.commons.csv.CSVPrinter;

import io.github.knotresolver.measure.FilamentSummary;
import io.github.knotresolver.measure.Gliding;
import io.github.knotresolver.measure.MeasuredFilament;
import io.github.knotresolver.measure.MeasuredTracks;

/**
 * {@code filaments.csv}: one row a filament. {@code first_frame} and
 * {@code last_frame} are the first and the last one in which it is in view, of
 * those that were not left out;
 * {@code length} and its standard error {@code length_se} are in the row's
 * {@code unit}; what is not known is empty. Of a free filament, {@code gliding_path} is how far
 * it went along itself towards its leading end, and {@code gliding_speed} that by the time,
 * in {@code unit} by {@code time_unit}.
 */
public final class FilamentsCsv {

	/** The file's name in a result folder. */
	public static final String FILE = "filaments.csv";

	private static final String[] HEADER = {ContoursCsv.FILAMENT, "anchor", "first_frame",
		"last_frame", "length", "length_se", "frames_resolved", "mean_confidence", "unit",
		"gliding_path", "gliding_speed", "time_unit"};

	private FilamentsCsv() {
	}

	/**
	 * @param file the file to write
	 * @param result a measured result
	 * @throws IOException if the file cannot be written
	 */
	public static void write(final Path file, final MeasuredTracks result) throws IOException {
		try (CSVPrinter csv = CsvFile.create(file, HEADER)) {
			for (final MeasuredFilament filament : result.filaments()) {
				final FilamentSummary s = FilamentSummary.of(filament, result.calibration());
				csv.printRecord(filament.track().id(), filament.track().anchor().label(),
					s.firstFrame().isPresent() ? s.firstFrame().getAsInt() : "",
					s.lastFrame().isPresent() ? s.lastFrame().getAsInt() : "",
					NumberText.significant(s.length()), NumberText.significant(s.lengthError()),
					filament.track().resolved(), NumberText.significant(s.confidence()),
					result.calibration().unit(), NumberText.significant(gliding(s, Gliding::path)),
					NumberText.significant(gliding(s, Gliding::speed)),
					result.calibration().timeUnit());
			}
		}
	}

	private static double gliding(final FilamentSummary s,
		final ToDoubleFunction<Gliding> quantity) {
		return s.gliding().map(quantity::applyAsDouble).orElse(Double.NaN);
	}
}
