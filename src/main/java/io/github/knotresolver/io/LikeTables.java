package io.github.knotresolver.io;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;

import org.apache.commons.csv.CSVPrinter;

import io.github.knotresolver.evaluate.Evaluation.FrameScore;
import io.github.knotresolver.evaluate.EvaluationSummary;
import io.github.knotresolver.evaluate.like.LikeReport;
import io.github.knotresolver.evaluate.like.LikeResult;
import io.github.knotresolver.evaluate.like.LikeResult.LikeMovie;

/**
 * The tables of a study of movies like a user's: {@code movies.csv} with a row a
 * movie, {@code frames.csv} with a row a frame of every movie,
 * {@code resemblance.csv} with a row a quantity, and {@code summary.txt}.
 */
public final class LikeTables {

	/** Names of the tables in the folder. */
	public static final String MOVIES = "movies.csv", FRAMES = "frames.csv",
		RESEMBLANCE = "resemblance.csv", SUMMARY = "summary.txt";

	private LikeTables() {
	}

	/**
	 * @param folder an existing folder
	 * @param result the study
	 * @throws IOException if a file cannot be written
	 */
	public static void write(final Path folder, final LikeResult result) throws IOException {
		writeMovies(folder.resolve(MOVIES), result);
		writeFrames(folder.resolve(FRAMES), result);
		writeResemblance(folder.resolve(RESEMBLANCE), result);
		Files.writeString(folder.resolve(SUMMARY),
			String.join("\n", LikeReport.lines(result)) + "\n", StandardCharsets.UTF_8);
	}

	private static void writeMovies(final Path file, final LikeResult result) throws IOException {
		try (CSVPrinter csv = CsvFile.create(file, "movie", "seed", "frames", "present", "resolved",
			"knotted", "knotted_resolved", "crossing", "resolved_pct", "dice", "frechet_px",
			"err_px", "miss_px", "len_err_pct")) {
			int movie = 0;
			for (final LikeMovie m : result.movies()) {
				final EvaluationSummary s = m.evaluation().summary();
				csv.printRecord(++movie, m.seed(), s.frames(), s.framesPresent(), m.resolved(),
					m.knottedFrames(), m.knottedResolved(), s.framesWithCrossings(),
					NumberText.significant(s.percentResolved()),
					NumberText.significant(s.meanDice()), EvaluationCsv.number(s.medianFrechet()),
					NumberText.significant(s.meanError()), NumberText.significant(s.meanMiss()),
					NumberText.significant(s.medianAbsoluteLengthError()));
			}
		}
	}

	private static void writeFrames(final Path file, final LikeResult result) throws IOException {
		try (CSVPrinter csv = CsvFile.create(file, "movie", "frame", "knotted", "crossings",
			"present", "resolved", "confidence", "dice", "frechet_px", "err_px", "len_err_pct")) {
			int movie = 0;
			for (final LikeMovie m : result.movies()) {
				movie++;
				for (int i = 0; i < m.evaluation().frames().size(); i++) {
					final FrameScore f = m.evaluation().frames().get(i);
					csv.printRecord(movie, f.frame(), m.knotted().get(i) ? 1 : 0, f.crossings(),
						f.present() ? 1 : 0, f.score().isResolved() ? 1 : 0,
						NumberText.significant(m.confidence().get(i)),
						NumberText.significant(f.score().dice()),
						EvaluationCsv.number(f.score().frechet()),
						EvaluationCsv.number(f.score().error()),
						NumberText.significant(f.score().lengthError()));
				}
			}
		}
	}

	private static void writeResemblance(final Path file, final LikeResult result)
		throws IOException {
		try (CSVPrinter csv = CsvFile.create(file, "quantity", "yours", "simulated")) {
			for (final Map.Entry<String, Double> trait : result.traits().values().entrySet())
				csv.printRecord(trait.getKey(), NumberText.significant(trait.getValue()),
					NumberText.significant(result.simulated(trait.getKey())));
		}
	}
}
