package io.github.knotresolver.imagej;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.stream.IntStream;

import io.github.knotresolver.io.BatchFolders;
import io.github.knotresolver.io.BatchFolders.Rows;
import io.github.knotresolver.io.BatchList;
import io.github.knotresolver.io.BatchOutcome;
import io.github.knotresolver.io.BatchRow;
import io.github.knotresolver.model.UserException;
import io.github.knotresolver.progress.Cancellation;
import io.github.knotresolver.progress.Lanes;
import io.github.knotresolver.progress.ManyProgress;
import io.github.knotresolver.progress.Progress;

/**
 * All rows of a batch, side by side. Their folders get their names in the order of the rows, whichever
 * ends first. A row for which memory was too short beside others has a second turn at the end, alone.
 */
final class BatchRun {

	/** What of Java's memory movies may take together. */
	private static final double SHARE = 0.8;

	private final BatchTurn turn;
	private final BatchList list;
	private final Consumer<BatchOutcome> listener;
	private final List<Work> again = new ArrayList<>();

	/** A row that has work to do. */
	private record Work(int index, BatchRow row, String folder, ManyProgress.Part part) {
	}

	/**
	 * @param turn resolves a row
	 * @param list takes what came of them
	 * @param listener told of every outcome as it comes, by one thread at a time
	 */
	BatchRun(final BatchTurn turn, final BatchList list, final Consumer<BatchOutcome> listener) {
		this.turn = turn;
		this.list = list;
		this.listener = listener;
	}

	/**
	 * Gives rows their turn.
	 *
	 * @param rows all rows of the sheet
	 * @param part those that have their turn; the others only keep their names
	 * @param folders where their results are, or go
	 * @param progress may cancel
	 * @throws IOException if the list cannot be written
	 */
	void all(final List<BatchRow> rows, final Rows part, final BatchFolders folders,
		final Progress progress) throws IOException {
		final int count = (int) IntStream.range(0, rows.size()).filter(part::has).count();
		final ManyProgress many = new ManyProgress(progress, count, "movies");
		final long room = (long) (SHARE * Runtime.getRuntime().maxMemory());
		final int most = Math.max(1, Math.min(turn.movies().orElse(turn.threads()), count));
		try {
			try (Lanes lanes = new Lanes(most, room)) {
				for (int i = 0; i < rows.size(); i++) {
					progress.checkCancelled();
					final Optional<Work> work = work(i, rows.get(i), folders, part.has(i), many);
					if (work.isEmpty())
						continue;
					final long need = MovieMemory.of(rows.get(i));
					final int own = threads(Math.min(most, count - list.outcomes().size()),
						room / need);
					lanes.start(need, work.get().part(), () -> beside(work.get(), own));
				}
				lanes.join(progress);
			}
			alone();
		} catch (final UncheckedIOException e) {
			throw e.getCause();
		}
	}

	/** @return the share of a movie beside which so many others can run, by rows and by memory */
	private int threads(final int byRows, final long byMemory) {
		final long beside = Math.max(1, Math.min(byRows, Math.max(1, byMemory)));
		return (int) Math.max(1, turn.threads() / beside);
	}

	/** @return what is left to do for a row; empty if nothing is */
	private Optional<Work> work(final int index, final BatchRow row, final BatchFolders folders,
		final boolean hasTurn, final ManyProgress many) {
		Optional<BatchOutcome> known;
		try {
			final BatchFolders.Place place = folders.place(row);
			if (!hasTurn)
				return Optional.empty();
			known = turn.isDone(row, place);
			if (known.isEmpty())
				return Optional.of(new Work(index, row, place.name(), many.part(row.name())));
		} catch (final UserException e) {
			if (!hasTurn)
				return Optional.empty();
			known = Optional.of(turn.failed(row, e));
		}
		known.ifPresent(outcome -> end(index, outcome));
		many.part(row.name()).close();
		return Optional.empty();
	}

	private void beside(final Work work, final int threads) {
		try {
			end(work.index(), turn.resolve(work.row(), work.folder(), threads, work.part()));
			work.part().close();
		} catch (final OutOfMemoryError e) {
			synchronized (this) {
				again.add(work);
			}
			work.part().report("waits for memory", 0);
		}
	}

	/** Memory was short, perhaps by the fault of another one. */
	private void alone() {
		again.sort(Comparator.comparingInt(Work::index));
		for (final Work work : again) {
			try {
				end(work.index(), Cancellation.during(work.part(),
					() -> turn.resolve(work.row(), work.folder(), turn.threads(), work.part())));
			} catch (final OutOfMemoryError e) {
				end(work.index(), turn.failed(work.row(), e));
			}
			work.part().close();
		}
	}

	private synchronized void end(final int index, final BatchOutcome outcome) {
		try {
			list.add(index, outcome);
		} catch (final IOException e) {
			throw new UncheckedIOException(e);
		}
		listener.accept(outcome);
	}
}
