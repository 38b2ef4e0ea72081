package io.github.knotresolver.ui.model;

import java.util.List;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.atomic.AtomicInteger;

import io.github.knotresolver.model.Constraint;
import io.github.knotresolver.model.Tracks;
import io.github.knotresolver.progress.CancelledException;
import io.github.knotresolver.progress.Progress;

/**
 * Asks a solver in a thread of its own. A new question stops the work on the one before, whose
 * answer never comes.
 */
final class LatestAnswer implements AutoCloseable {

	/** Hears of questions. Called by the solver's thread. */
	interface Asker {

		void answered(List<Constraint> said, Tracks tracks);

		void failed(List<Constraint> said, Throwable why);

		void worked(List<Constraint> said, String stage);
	}

	private final Solver solver;
	private final Asker asker;
	private final AtomicInteger latest = new AtomicInteger();
	private final ExecutorService thread = Executors.newSingleThreadExecutor(work -> {
		final Thread t = new Thread(work, "KnotResolver review");
		t.setDaemon(true);
		return t;
	});

	LatestAnswer(final Solver solver, final Asker asker) {
		this.solver = solver;
		this.asker = asker;
	}

	/** Asks; returns at once. */
	void ask(final List<Constraint> said) {
		final Question question = new Question(latest.incrementAndGet(), said);
		thread.execute(() -> answer(said, question));
	}

	private void answer(final List<Constraint> said, final Question question) {
		try {
			question.checkCancelled();
			final Tracks tracks = solver.solve(said, question);
			question.checkCancelled();
			asker.answered(said, tracks);
		} catch (final CancelledException e) {
			// Another question is being answered, or nobody listens any more.
		} catch (final RuntimeException | Error e) {
			if (!question.isCancelled())
				asker.failed(said, e);
		}
	}

	/** Stops the work on the last question; its answer never comes. */
	@Override
	public void close() {
		latest.incrementAndGet();
		thread.shutdown();
	}

	/** One question among others. */
	private final class Question implements Progress {

		private final int number;
		private final List<Constraint> said;

		Question(final int number, final List<Constraint> said) {
			this.number = number;
			this.said = said;
		}

		@Override
		public void report(final String stage, final double fraction) {
			if (!isCancelled())
				asker.worked(said, stage);
		}

		@Override
		public boolean isCancelled() {
			return latest.get() != number;
		}
	}
}
