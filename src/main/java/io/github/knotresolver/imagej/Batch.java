package io.github.knotresolver.imagej;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.function.Consumer;

import ij.ImagePlus;
import io.github.knotresolver.io.BatchOutcome;
import io.github.knotresolver.io.BatchOutcome.Status;
import io.github.knotresolver.io.BatchRow;
import io.github.knotresolver.io.CorrectionsCsv;
import io.github.knotresolver.io.Failure;
import io.github.knotresolver.io.MeasuredTracks;
import io.github.knotresolver.io.ResultFolder;
import io.github.knotresolver.io.RunReport;
import io.github.knotresolver.model.Movie;
import io.github.knotresolver.model.UserException;
import io.github.knotresolver.options.RunOptions;
import io.github.knotresolver.progress.CancelledException;
import io.github.knotresolver.progress.Progress;

/**
 * Many movies, one after the other, each with its own result folder. A movie
 * that fails is reported and the rest go on; one that is finished is not done
 * again.
 *
 * @param engine what resolves a movie
 * @param defaults options of all rows, by key; a row's own go over them
 * @param overwrite whether finished rows are done again
 * @param plots whether plots are written
 */
public record Batch(Engine engine, Map<String, String> defaults, boolean overwrite, boolean plots) {

	/**
	 * Resolves all rows, and writes the list of what came of them.
	 *
	 * @param rows the rows
	 * @param out the folder of the result folders; made if absent
	 * @param listener told of every outcome as it comes
	 * @param progress may cancel; what is finished by then stays
	 * @return what came of the rows, in their order
	 * @throws UserException if the folder cannot be written, in one
	 *           sentence
	 * @throws IOException if the list cannot be written
	 */
	public List<BatchOutcome> run(final List<BatchRow> rows, final Path out,
		final Consumer<BatchOutcome> listener, final Progress progress) throws IOException {
		requireWritable(out);
		final List<BatchOutcome> outcomes = new ArrayList<>();
		final Set<String> names = new HashSet<>();
		try {
			for (final BatchRow row : rows) {
				progress.checkCancelled();
				final Path folder = out.resolve(name(row, names));
				final BatchOutcome outcome = resolve(row, folder,
					new Part(progress, outcomes.size(), rows.size()));
				outcomes.add(outcome);
				listener.accept(outcome);
			}
			return outcomes;
		} finally {
			BatchOutcome.write(out.resolve(BatchOutcome.FILE), outcomes);
		}
	}

	private static void requireWritable(final Path out) {
		try {
			Files.createDirectories(out);
		} catch (final IOException e) {
			throw new UserException(
				"The folder " + out + " cannot be made; choose another one in a writable place.",
				e);
		}
		if (!Files.isWritable(out))
			throw new UserException(
				"The folder " + out + " is not writable; choose another one.");
	}

	/** The movie's name without its ending; numbered if it comes again. */
	private static String name(final BatchRow row, final Set<String> taken) {
		final String stem = row.movie().getFileName().toString().replaceFirst("\\.[^.]*$", "");
		String name = stem;
		for (int i = 2; !taken.add(name); i++)
			name = stem + "-" + i;
		return name;
	}

	private BatchOutcome resolve(final BatchRow row, final Path folder, final Progress progress) {
		if (!overwrite && ResultFolder.isResult(folder))
			return new BatchOutcome(row, Status.SKIPPED, folder,
				"There is a result already; add force to do it again.");
		try {
			final MeasuredTracks result = result(row, folder, progress);
			final List<String> words = new ArrayList<>(row.notes());
			words.add(0, RunReport.lines(result).get(0));
			return new BatchOutcome(row, Status.FINISHED, folder, String.join(" ", words));
		} catch (final CancelledException e) {
			throw e;
		} catch (final RuntimeException | IOException | Error e) {
			return new BatchOutcome(row, Status.FAILED, folder,
				Failure.of(e, "give Java more").sentence());
		}
	}

	private MeasuredTracks result(final BatchRow row, final Path folder,
		final Progress progress) throws IOException {
		row.requireTryable();
		final Map<String, String> texts = new TreeMap<>(defaults);
		texts.putAll(row.texts());
		final RunOptions options = RunOptions.parse(texts);
		ResultFolder.check(folder, overwrite);
		final ImagePlus image = ImageFile.open(row.movie());
		final Movie movie = ImageMovie.of(image, options.input());
		final MeasuredTracks result = MeasuredTracks.of(engine.resolve(movie,
			options.settings(movie, CorrectionsCsv.of(options)),
			progress), progress);
		final RoiConverter rois = RoiConverter.forImage(image, options.input().channel());
		new ResultWriter(result, options.input(), rois, ImageFile.of(image)).write(folder,
			overwrite, plots, progress);
		return result;
	}

	/** Progress of one row as a part of the whole. */
	private record Part(Progress whole, int done, int rows) implements Progress {

		@Override
		public void report(final String stage, final double fraction) {
			whole.report("Movie " + (done + 1) + " of " + rows + ": " + stage,
				(done + fraction) / rows);
		}

		@Override
		public boolean isCancelled() {
			return whole.isCancelled();
		}
	}
}
