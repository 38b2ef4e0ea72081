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
import io.github.knotresolver.io.BatchRow;
import io.github.knotresolver.io.RunIdentity;
import io.github.knotresolver.model.UserException;
import io.github.knotresolver.progress.Progress;
import io.github.knotresolver.run.Engine;

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
	 * @param rows the rows
	 * @param out the folder of the result folders; made if absent
	 * @param inputs what else is read, such as the sheet
	 * @param listener told of every outcome as it comes, by one thread at a time
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
			final BatchTurn turn = new BatchTurn(this, out, read);
			final BatchRun run = new BatchRun(turn, list, listener, progress);
			run.all(rows, folders);
			list.page(file -> BatchPage.write(file, out, list.outcomes(), progress));
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
}
