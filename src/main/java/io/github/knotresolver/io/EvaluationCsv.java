
package io.github.knotresolver.io;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;

import org.apache.commons.csv.CSVPrinter;

import io.github.knotresolver.evaluate.CurveScore;
import io.github.knotresolver.evaluate.Evaluation;
import io.github.knotresolver.evaluate.FrameScore;
import io.github.knotresolver.model.UserException;

/**
 * The scores of a result, one row for every frame of the truth. Distances are in
 * pixels; those of a frame without a contour are {@code inf}.
 */
public final class EvaluationCsv {

	private static final String[] HEADER = {"frame", "present", "crossings", "resolved", "dice",
		"tp", "fp", "fn", "frechet_px", "frechet_rev_px", "err_px", "miss_px", "len_err_pct"};

	private EvaluationCsv() {
	}

	/**
	 * @param file the file to write
	 * @param evaluation the scores
	 * @throws IOException if the disk says no
	 */
	public static void write(final Path file, final Evaluation evaluation) throws IOException {
		try (CSVPrinter csv = CsvFile.create(file, HEADER)) {
			for (final FrameScore f : evaluation.frames()) {
				final CurveScore s = f.score();
				csv.printRecord(f.frame(), f.present() ? 1 : 0, f.crossings(),
					s.isResolved() ? 1 : 0, number(s.dice()), s.truePositives(), s.falsePositives(),
					s.falseNegatives(), number(s.frechet()), number(s.frechetReversed()),
					number(s.error()), number(s.miss()), number(s.lengthError()));
			}
		}
	}

	/**
	 * @param out where the scores are to go
	 * @throws UserException if they cannot be written there, in one
	 *           sentence
	 */
	public static void requireWritable(final Path out) {
		final Path folder = out.toAbsolutePath().normalize().getParent();
		if (folder == null || Files.isDirectory(out) || !Files.isDirectory(folder)
			|| !Files.isWritable(Files.exists(out) ? out : folder))
			throw new UserException(
				"out " + out + " cannot be written; choose a file in a writable folder.");
	}

	/** @return the number, or {@code inf} */
	static String number(final double value) {
		return value == Double.POSITIVE_INFINITY ? "inf" : NumberText.significant(value);
	}
}
