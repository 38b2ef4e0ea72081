package io.github.knotresolver.imagej;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;

import io.github.knotresolver.evaluate.Evaluation;
import io.github.knotresolver.imagej.plot.ScoreFigures;
import io.github.knotresolver.io.EvaluationCsv;
import io.github.knotresolver.model.UserException;
import io.github.knotresolver.progress.Progress;

/** An evaluation as a table, with its figures beside it. */
public final class ScoreFiles {

	private ScoreFiles() {
	}

	/**
	 * @param out where the table is to go
	 * @throws UserException if it cannot be written there, in one
	 *           sentence
	 */
	public static void requireWritable(final Path out) {
		EvaluationCsv.requireWritable(out);
	}

	/**
	 * Writes {@code scores.csv}, say, and beside it {@code scores-position_error.png},
	 * {@code .svg} and so on.
	 *
	 * @param out the table
	 * @param evaluation the scores
	 * @param plots whether figures are drawn
	 * @param progress may cancel
	 * @throws IOException if the disk says no
	 */
	public static void write(final Path out, final Evaluation evaluation, final boolean plots,
		final Progress progress) throws IOException {
		EvaluationCsv.write(out, evaluation);
		if (!plots)
			return;
		final Path file = out.toAbsolutePath().normalize();
		final String stem = file.getFileName().toString().replaceFirst("\\.[^.]+$", "");
		ScoreFigures.write(file.getParent(), stem + "-", List.of(evaluation.frames()),
			evaluation.positionErrors(), progress);
	}
}
