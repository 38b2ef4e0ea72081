package io.github.knotresolver.ui.model;

import java.util.List;

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
	private final LatestWork work = new LatestWork("KnotResolver review");

	LatestAnswer(final Solver solver, final Asker asker) {
		this.solver = solver;
		this.asker = asker;
	}

	/** Asks; returns at once. */
	void ask(final List<Constraint> said) {
		work.start(stage -> asker.worked(said, stage), progress -> answer(said, progress));
	}

	private void answer(final List<Constraint> said, final Progress progress) {
		try {
			final Tracks tracks = solver.solve(said, progress);
			progress.checkCancelled();
			asker.answered(said, tracks);
		} catch (final CancelledException e) {
			throw e;
		} catch (final RuntimeException | Error e) {
			if (!progress.isCancelled())
				asker.failed(said, e);
		}
	}

	/** Stops the work on the last question; its answer never comes. */
	@Override
	public void close() {
		work.close();
	}
}
