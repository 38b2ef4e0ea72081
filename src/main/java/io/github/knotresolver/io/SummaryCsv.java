
package io.github.knotresolver.io;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.OptionalDouble;

import org.apache.commons.csv.CSVPrinter;

import io.github.knotresolver.geometry.Calibration;
import io.github.knotresolver.pipeline.Resolution;

/**
 * {@code summary.csv}: one row for the movie. Lengths are in {@code unit}, the
 * dominant frequency of the tip angle in {@code frequency_unit};
 * {@code parameters} are the options on one line, as a macro has them.
 */
public final class SummaryCsv {

	/** The file's name in a result folder. */
	public static final String FILE = "summary.csv";

	private static final String[] HEADER = {"movie", "frames", "resolved", "length_mean",
		"length_median", "length_sd", "length_min", "length_max", "unit", "dominant_frequency",
		"frequency_unit", "version", "parameters"};

	private SummaryCsv() {
	}

	/**
	 * @param file the file to write
	 * @param resolution the result
	 * @param frames its frames, measured
	 * @param dominantFrequency of the tip angle; empty if none stands out
	 * @param input how the movie was taken from its image
	 * @throws IOException if the disk says no
	 */
	public static void write(final Path file, final Resolution resolution,
		final List<MeasuredFrame> frames, final OptionalDouble dominantFrequency,
		final InputOptions input) throws IOException {
		final LengthStatistics s = LengthStatistics.of(frames);
		final Calibration c = resolution.movie().calibration();
		try (CSVPrinter csv = CsvFile.create(file, HEADER)) {
			csv.printRecord(resolution.movie().name(), resolution.movie().size(),
				resolution.resolved(), NumberText.significant(s.mean()),
				NumberText.significant(s.median()), NumberText.significant(s.sd()),
				NumberText.significant(s.min()), NumberText.significant(s.max()), c.unit(),
				NumberText.significant(dominantFrequency.orElse(Double.NaN)), frequencyUnit(c),
				ProgramVersion.get(), ParametersJson.line(resolution, input));
		}
	}

	/**
	 * @param c a calibration
	 * @return {@code Hz}, or {@code 1/unit of time}
	 */
	static String frequencyUnit(final Calibration c) {
		return c.timeUnit().equals("s") ? "Hz" : "1/" + c.timeUnit();
	}
}
