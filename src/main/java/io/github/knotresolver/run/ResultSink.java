package io.github.knotresolver.run;

import java.io.IOException;

import io.github.knotresolver.progress.CancelledException;
import io.github.knotresolver.progress.Progress;

/** Where a result goes. */
@FunctionalInterface
public interface ResultSink {

	/** Keeps nothing. */
	ResultSink NONE = (outcome, progress) -> {
	};

	/**
	 * Takes the whole result or, if it fails, nothing.
	 *
	 * @param outcome the result
	 * @param progress told how far it is; may cancel
	 * @throws CancelledException if the user asked to stop
	 * @throws IOException if a file cannot be written
	 */
	void write(Outcome outcome, Progress progress) throws IOException;
}
