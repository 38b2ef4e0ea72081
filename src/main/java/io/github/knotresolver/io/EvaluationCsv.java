
package io.github.knotresolver.io;

import java.io.BufferedReader;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.OptionalInt;

import org.apache.commons.csv.CSVPrinter;

import io.github.knotresolver.evaluate.CurveScore;
import io.github.knotresolver.evaluate.Evaluation;
import io.github.knotresolver.evaluate.Evaluation.FrameScore;
import io.github.knotresolver.evaluate.SceneEvaluation.FilamentScore;

/**
 * The scores of a result, one row for every frame of the truth. Distances are in
 * pixels; those of a frame without a contour are {@code inf}.
 */
public final class EvaluationCsv {

	private static final String[] HEADER = {"frame", "present", "crossings", "resolved", "dice",
		"tp", "fp", "fn", "frechet_px", "frechet_rev_px", "err_px", "miss_px", "len_err_pct",
		ContoursCsv.FILAMENT, "result_filament"};

	private EvaluationCsv() {
	}

	/**
	 * @param file the file to write
	 * @param evaluation the scores
	 * @throws IOException if a file cannot be written
	 */
	public static void write(final Path file, final Evaluation evaluation) throws IOException {
		write(file, List.of(new FilamentScore(1, OptionalInt.of(1), false, evaluation)));
	}

	/**
	 * @param file the file to write
	 * @param filaments the scores of the true filaments, one after the other
	 * @throws IOException if the file cannot be written
	 */
	public static void write(final Path file, final List<FilamentScore> filaments)
		throws IOException {
		try (CSVPrinter csv = CsvFile.create(file, HEADER)) {
			for (final FilamentScore filament : filaments)
				writeRows(csv, filament);
		}
	}

	private static void writeRows(final CSVPrinter csv, final FilamentScore filament)
		throws IOException {
		for (final FrameScore f : filament.evaluation().frames()) {
			final CurveScore s = f.score();
			csv.printRecord(f.frame(), f.present() ? 1 : 0, f.crossings(), s.isResolved() ? 1 : 0,
				number(s.dice()), s.truePositives(), s.falsePositives(), s.falseNegatives(),
				number(s.frechet()), number(s.frechetReversed()), number(s.error()),
				number(s.miss()), number(s.lengthError()), filament.filament(),
				filament.isGiven() ? filament.result().getAsInt() : "");
		}
	}

	/**
	 * @param file an existing file
	 * @return whether it is a table of scores that this program wrote
	 */
	public static boolean isOurs(final Path file) {
		try (BufferedReader reader = Files.newBufferedReader(file, StandardCharsets.UTF_8)) {
			return String.join(",", HEADER).equals(reader.readLine());
		} catch (final IOException e) {
			return false;
		}
	}

	/** @return the number, or {@code inf} */
	static String number(final double value) {
		return value == Double.POSITIVE_INFINITY ? "inf" : NumberText.significant(value);
	}
}
