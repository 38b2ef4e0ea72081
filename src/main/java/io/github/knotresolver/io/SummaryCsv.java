
package io.github.knotresolver.io;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Optional;
import java.util.function.ToDoubleFunction;

import org.apache.commons.csv.CSVPrinter;

import io.github.knotresolver.measure.DominantFrequency;
import io.github.knotresolver.measure.LengthStatistics;
import io.github.knotresolver.measure.MeasuredTracks;
import io.github.knotresolver.model.Tracks;
import io.github.knotresolver.options.InputOptions;

/**
 * {@code summary.csv}: one row for the movie, all filaments together. Lengths are in {@code unit}, the
 * dominant frequency of the tip angle of the only filament and its standard error in
 * {@code frequency_unit}; {@code false_alarm} is the probability that noise alone
 * shows such a peak (0..1);
 * {@code parameters} are the options on one line, as a macro has them.
 */
public final class SummaryCsv {

	/** The file's name in a result folder. */
	public static final String FILE = "summary.csv";

	private static final String[] HEADER = {"movie", "frames", "resolved", "length_mean",
		"length_median", "length_sd", "length_min", "length_max", "unit", "dominant_frequency",
		"dominant_frequency_se", "false_alarm", "frequency_unit", "version", "parameters",
		"filaments"};

	private SummaryCsv() {
	}

	/**
	 * @param file the file to write
	 * @param result a measured result
	 * @param input how the movie was taken from its image
	 * @throws IOException if a file cannot be written
	 */
	public static void write(final Path file, final MeasuredTracks result, final InputOptions input)
		throws IOException {
		final LengthStatistics s = LengthStatistics.of(result.frames());
		final Tracks tracks = result.tracks();
		final Optional<DominantFrequency> f = result.dominantFrequency();
		try (CSVPrinter csv = CsvFile.create(file, HEADER)) {
			csv.printRecord(tracks.movie().name(), tracks.movie().size(), tracks.resolved(),
				NumberText.significant(s.mean()), NumberText.significant(s.median()),
				NumberText.significant(s.sd()), NumberText.significant(s.min()),
				NumberText.significant(s.max()), result.calibration().unit(),
				text(f, DominantFrequency::frequency), text(f, DominantFrequency::standardError),
				text(f, DominantFrequency::falseAlarmProbability),
				result.calibration().frequencyUnit(), ProgramVersion.get(),
				ParametersJson.line(tracks, input), tracks.filaments().size());
		}
	}

	private static String text(final Optional<DominantFrequency> frequency,
		final ToDoubleFunction<DominantFrequency> value) {
		return frequency.map(f -> NumberText.significant(value.applyAsDouble(f))).orElse("");
	}
}
