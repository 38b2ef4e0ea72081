package io.github.knotresolver.imagej;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;

import io.github.knotresolver.io.BatchFolders;
import io.github.knotresolver.io.BatchFolders.Rows;
import io.github.knotresolver.io.BatchList;
import io.github.knotresolver.io.BatchOutcome;
import io.github.knotresolver.io.BatchRow;
import io.github.knotresolver.model.UserException;
import io.github.knotresolver.progress.Progress;
import io.github.knotresolver.session.Engine;

/**
 * Many movies, as many at a time as threads and memory allow, each with its own result folder: the
 * same bytes as one by one. A movie that fails is reported and the rest go on; one that is finished is
 * not done again. At the end comes a page that shows all results.
 *
 * @param engine what resolves a movie
 * @param defaults options of all rows, by key; a row's own go over them. {@code threads} is how many
 *          all movies have together
 * @param overwrite whether finished rows are done again
 * @param plots whether plots are written
 * @param movies most movies at a time, at least 1; empty for as many as threads and memory allow
 */
public record Batch(Engine engine, Map<String, String> defaults, boolean overwrite, boolean plots,
	Optional<Integer> movies) {

	public Batch {
		defaults = Map.copyOf(defaults);
		movies.ifPresent(Batch::requirePositive);
	}

	private static void requirePositive(final int movies) {
		if (movies < 1)
			throw new UserException("movies must be at least 1, but is " + movies + ".");
	}

	/**
	 * Resolves all rows, and writes the list of what came of them and the page that shows it.
	 *
	 * @param work the rows and their place
	 * @param listener told of every outcome as it comes, by one thread at a time
	 * @param progress may cancel; what is finished by then stays
	 * @return what came of the rows, in their order
	 * @throws UserException if the folder cannot be written, in one
	 *           sentence
	 * @throws IOException if the list cannot be written
	 */
	public List<BatchOutcome> run(final BatchWork work, final Consumer<BatchOutcome> listener,
		final Progress progress) throws IOException {
		final List<Path> read = work.files(defaults);
		try (BatchList list = BatchList.open(work.out(), read)) {
			run(work, Rows.ALL, new BatchRun(new BatchTurn(this, work.out(), read), list, listener),
				progress);
			list.page(file -> BatchPage.write(file, work.out(), list.outcomes(), progress));
			return list.outcomes();
		}
	}

	/**
	 * Resolves some of the rows, as one of several processes that share the folder: all of them give
	 * results the names that one process would give them. What came of the rows is in a list of their
	 * own, for {@link #collect}.
	 *
	 * @param work all rows and their place
	 * @param part those that have their turn
	 * @param listener told of every outcome as it comes, by one thread at a time
	 * @param progress may cancel; what is finished by then stays
	 * @return what came of these rows, in their order
	 * @throws UserException if there are no such rows, or the folder cannot be written,
	 *           in one sentence
	 * @throws IOException if the list cannot be written
	 */
	public List<BatchOutcome> part(final BatchWork work, final Rows part,
		final Consumer<BatchOutcome> listener, final Progress progress) throws IOException {
		if (part.last() > work.rows().size())
			throw new UserException("rows must be from 1 to " + work.rows().size()
				+ ", as many as the sheet has, but is " + part.label() + ".");
		final List<Path> read = work.files(defaults);
		try (BatchList list = BatchList.open(work.out(), part.label(), read)) {
			run(work, part, new BatchRun(new BatchTurn(this, work.out(), read), list, listener),
				progress);
			return list.outcomes();
		}
	}

	private void run(final BatchWork work, final Rows part, final BatchRun run,
		final Progress progress) throws IOException {
		run.all(work.rows(), part,
			BatchFolders.of(work.out(), work.rows(), defaults, part, progress), progress);
	}

	/**
	 * Writes the list and the page of what {@link #part} made, and resolves nothing.
	 *
	 * @param work all rows and their place
	 * @param progress may cancel
	 * @return what came of the rows, in their order
	 * @throws UserException if the folder cannot be written, in one
	 *           sentence
	 * @throws IOException if the list cannot be written
	 */
	public List<BatchOutcome> collect(final BatchWork work, final Progress progress)
		throws IOException {
		try (BatchList list = BatchList.open(work.out(), work.files(defaults))) {
			final BatchFolders folders = BatchFolders.of(work.out(), work.rows(), defaults,
				Rows.NONE, progress);
			final Map<BatchRow, BatchOutcome> told = BatchList.told(work.out(), work.rows());
			for (int i = 0; i < work.rows().size(); i++)
				list.note(i, collected(work.rows().get(i), folders, told));
			list.write();
			list.page(file -> BatchPage.write(file, work.out(), list.outcomes(), progress));
			return list.outcomes();
		}
	}

	private static BatchOutcome collected(final BatchRow row, final BatchFolders folders,
		final Map<BatchRow, BatchOutcome> told) {
		try {
			final BatchFolders.Place place = folders.place(row);
			final BatchOutcome outcome = told.getOrDefault(row,
				BatchOutcome.failed(row, "There is no result; resolve this row."));
			if (!place.isFinished())
				return BatchOutcome.failed(row, outcome.message());
			return outcome.folder().isPresent() ? outcome : BatchOutcome.skipped(row, place.name());
		} catch (final UserException e) {
			return BatchOutcome.failed(row, e.getMessage());
		}
	}
}
