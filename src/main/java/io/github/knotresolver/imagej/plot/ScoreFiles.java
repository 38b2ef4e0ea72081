package io.github.knotresolver.imagej.plot;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Collection;
import java.util.List;

import io.github.knotresolver.io.EvaluationCsv;
import io.github.knotresolver.io.OutputFiles;
import io.github.knotresolver.model.UserException;
import io.github.knotresolver.progress.Progress;
import io.github.knotresolver.run.Scores;

/** An evaluation as a table, with its figures beside it. */
public final class ScoreFiles implements AutoCloseable {

	private final String name;
	private final String prefix;
	private final boolean plots;
	private final OutputFiles files;

	private ScoreFiles(final String name, final String prefix, final boolean plots,
		final OutputFiles files) {
		this.name = name;
		this.prefix = prefix;
		this.plots = plots;
		this.files = files;
	}

	/**
	 * Reserves the places of {@code scores.csv}, say, and of
	 * {@code scores-position_error.png}, {@code .svg} and so on beside it.
	 *
	 * @param out the table
	 * @param plots whether figures are drawn
	 * @param overwrite whether earlier ones may be replaced
	 * @param inputs files that are read; they are never replaced
	 * @return the files, to be written and closed
	 * @throws UserException if they may not be written, in one sentence
	 * @throws IOException if nothing can be written there
	 */
	public static ScoreFiles reserve(final Path out, final boolean plots, final boolean overwrite,
		final Collection<Path> inputs) throws IOException {
		final Path name = out.toAbsolutePath().normalize().getFileName();
		if (name == null)
			throw new UserException("out " + out + " cannot be written; name a file.");
		final String prefix = name.toString().replaceFirst("\\.[^.]+$", "") + "-";
		final List<String> figures = plots ? ScoreFigures.files(prefix) : List.of();
		return new ScoreFiles(name.toString(), prefix, plots,
			OutputFiles.reserve(out, figures, EvaluationCsv::isOurs, overwrite, inputs));
	}

	/**
	 * @param scores of one filament, or of several
	 * @param progress may cancel; nothing is written then
	 * @return what was left out and why, a sentence or two each
	 * @throws IOException if the files cannot be written
	 */
	public List<String> write(final Scores scores, final Progress progress) throws IOException {
		EvaluationCsv.write(files.path().resolve(name), scores.filaments());
		final List<String> leftOut = plots
			? ScoreFigures.write(files.path(), prefix, scores.frames(), scores.positionErrors(),
				progress)
			: List.of();
		files.commit(name);
		return leftOut;
	}

	@Override
	public void close() throws IOException {
		files.close();
	}
}
