package io.github.knotresolver.run;

import java.io.IOException;
import java.util.List;

import io.github.knotresolver.progress.CancelledException;
import io.github.knotresolver.progress.Progress;

/** Where a result goes. */
@FunctionalInterface
public interface ResultSink {

	/** Keeps nothing. */
	ResultSink NONE = (outcome, progress) -> List.of();

	/**
	 * Takes the whole result or, if it fails, nothing.
	 *
	 * @param outcome the result
	 * @param progress told how far it is; may cancel
	 * @return what was left out and why, a sentence or two each
	 * @throws CancelledException if the user asked to stop
	 * @throws IOException if a file cannot be written
	 */
	List<String> write(FinishedRun outcome, Progress progress) throws IOException;
}
