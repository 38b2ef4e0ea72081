package io.github.knotresolver.imagej;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;

import io.github.knotresolver.io.BatchFolders;
import io.github.knotresolver.io.BatchList;
import io.github.knotresolver.io.BatchOutcome;
import io.github.knotresolver.io.BatchOutcome.Status;
import io.github.knotresolver.io.BatchRow;
import io.github.knotresolver.io.Failure;
import io.github.knotresolver.io.ResultFolder;
import io.github.knotresolver.io.ResultKind;
import io.github.knotresolver.io.RunIdentity;
import io.github.knotresolver.model.UserException;
import io.github.knotresolver.progress.CancelledException;
import io.github.knotresolver.progress.Progress;
import io.github.knotresolver.run.Engine;
import io.github.knotresolver.run.Outcome;
import io.github.knotresolver.run.ResolveRun;

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
	 * @param inputs what else is read, such as the sheet
	 * @param listener told of every outcome as it comes
	 * @param progress may cancel; what is finished by then stays
	 * @return what came of the rows, in their order
	 * @throws UserException if the folder cannot be written, in one
	 *           sentence
	 * @throws IOException if the list cannot be written
	 */
	public List<BatchOutcome> run(final List<BatchRow> rows, final Path out,
		final List<Path> inputs, final Consumer<BatchOutcome> listener, final Progress progress)
		throws IOException {
		final List<Path> read = new ArrayList<>(inputs);
		rows.forEach(row -> read.addAll(files(row)));
		try (BatchList list = BatchList.open(out, read)) {
			final BatchFolders folders = BatchFolders.of(out, rows, defaults, progress);
			for (final BatchRow row : rows) {
				progress.checkCancelled();
				final BatchOutcome outcome = new Row(row, out, folders, read)
					.resolve(new Part(progress, list.outcomes().size(), rows.size()));
				list.add(outcome);
				listener.accept(outcome);
			}
			return list.outcomes();
		}
	}

	private List<Path> files(final BatchRow row) {
		try {
			return RunIdentity.files(Optional.of(row.file()), row.over(defaults));
		} catch (final UserException e) {
			// The row is refused when it has its turn.
			return List.of();
		}
	}

	/** A row that has its turn. */
	private final class Row {

		private final BatchRow row;
		private final Path out;
		private final BatchFolders folders;
		private final List<Path> inputs;

		Row(final BatchRow row, final Path out, final BatchFolders folders,
			final List<Path> inputs) {
			this.row = row;
			this.out = out;
			this.folders = folders;
			this.inputs = inputs;
		}

		BatchOutcome resolve(final Progress progress) {
			try {
				final BatchFolders.Place place = folders.place(row);
				if (place.isFinished() && !overwrite)
					return new BatchOutcome(row, Status.SKIPPED, Optional.of(place.name()),
						"There is a result already; add force to do it again.");
				final Outcome outcome = outcome(out.resolve(place.name()), progress);
				final List<String> words = new ArrayList<>(row.notes());
				words.add(0, outcome.report().get(0));
				words.addAll(outcome.leftOut());
				return new BatchOutcome(row, Status.FINISHED, Optional.of(place.name()),
					String.join(" ", words));
			} catch (final CancelledException e) {
				throw e;
			} catch (final RuntimeException | IOException | Error e) {
				return BatchOutcome.failed(row, Failure.of(e, "give Java more").sentence());
			}
		}

		private Outcome outcome(final Path target, final Progress progress) throws IOException {
			final ResolveRun run = ResolveRun.of(row.over(defaults));
			try (ResultFolder folder = ResultFolder.reserve(target, ResultKind.RESOLUTION,
				overwrite, inputs)) {
				final ImageSource source = ImageSource.of(row.file());
				return run.read(source, progress).resolve(engine,
					new FolderSink(folder, source, plots), progress);
			}
		}
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
