package io.github.knotresolver.imagej;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;

import io.github.knotresolver.io.BatchFolders;
import io.github.knotresolver.io.BatchOutcome;
import io.github.knotresolver.io.BatchOutcome.Status;
import io.github.knotresolver.io.BatchRow;
import io.github.knotresolver.io.Failure;
import io.github.knotresolver.io.ResultFolder;
import io.github.knotresolver.io.ResultKind;
import io.github.knotresolver.model.UserException;
import io.github.knotresolver.progress.CancelledException;
import io.github.knotresolver.progress.Progress;
import io.github.knotresolver.run.FinishedRun;
import io.github.knotresolver.run.ResolveRun;

/** A row of a batch has its turn. May be asked by several threads. */
final class BatchTurn {

	private static final String THREADS = "threads";

	private final Batch batch;
	private final Path out;
	private final List<Path> inputs;

	/**
	 * @param batch what is the same for all rows
	 * @param out the existing folder of the result folders
	 * @param inputs files that are read; they are never replaced
	 */
	BatchTurn(final Batch batch, final Path out, final List<Path> inputs) {
		this.batch = batch;
		this.out = out;
		this.inputs = List.copyOf(inputs);
	}

	/** @return most movies at a time; empty for as many as threads and memory allow */
	Optional<Integer> movies() {
		return batch.movies();
	}

	/** @return how many threads all rows have together */
	int threads() {
		try {
			return Optional.ofNullable(batch.defaults().get(THREADS)).map(String::strip)
				.map(Integer::valueOf).orElseGet(Runtime.getRuntime()::availableProcessors);
		} catch (final NumberFormatException e) {
			// Each row says what is wrong with it.
			return 1;
		}
	}

	/**
	 * @param row a row
	 * @param place where its result is, or goes
	 * @return the outcome, if it is known without work
	 */
	Optional<BatchOutcome> isDone(final BatchRow row, final BatchFolders.Place place) {
		return place.isFinished() && !batch.overwrite()
			? Optional.of(BatchOutcome.skipped(row, place.name()))
			: Optional.empty();
	}

	/**
	 * Resolves a row.
	 *
	 * @param row the row
	 * @param name the name of its result folder
	 * @param threads how many it may use, unless it says so itself
	 * @param progress may cancel
	 * @return what came of it
	 * @throws OutOfMemoryError if there was too little memory, before anything was written
	 * @throws CancelledException if the user asked to stop
	 */
	BatchOutcome resolve(final BatchRow row, final String name, final int threads,
		final Progress progress) {
		try {
			final FinishedRun outcome = outcome(row, out.resolve(name), threads, progress);
			final List<String> words = new ArrayList<>(row.notes());
			words.add(0, outcome.report().get(0));
			words.addAll(outcome.leftOut());
			return new BatchOutcome(row, Status.FINISHED, Optional.of(name),
				String.join(" ", words));
		} catch (final CancelledException | OutOfMemoryError e) {
			throw e;
		} catch (final UserException e) {
			if (e.getCause() instanceof OutOfMemoryError memory)
				throw (OutOfMemoryError) new OutOfMemoryError(e.getMessage()).initCause(memory);
			return failed(row, e);
		} catch (final RuntimeException | IOException | Error e) {
			return failed(row, e);
		}
	}

	/**
	 * @param row a row
	 * @param cause why there is no result
	 * @return its outcome
	 */
	BatchOutcome failed(final BatchRow row, final Throwable cause) {
		final boolean told = cause instanceof OutOfMemoryError
			&& cause.getCause() instanceof OutOfMemoryError;
		return BatchOutcome.failed(row,
			told ? cause.getMessage() : Failure.of(cause, "give Java more").sentence());
	}

	private FinishedRun outcome(final BatchRow row, final Path target, final int threads,
		final Progress progress) throws IOException {
		final Map<String, String> texts = new TreeMap<>(batch.defaults());
		texts.put(THREADS, Integer.toString(threads));
		final ResolveRun run = ResolveRun.of(row.over(texts));
		try (ResultFolder folder = ResultFolder.reserve(target, ResultKind.RESOLVED_MOVIE,
			batch.overwrite(), inputs)) {
			final ImageSource source = ImageSource.of(row.file());
			return run.read(source, progress).resolve(batch.engine(),
				new FolderSink(folder, source, batch.plots()), progress);
		}
	}
}
