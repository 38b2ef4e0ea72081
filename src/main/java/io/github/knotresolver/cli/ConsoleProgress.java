package io.github.knotresolver.cli;

import java.io.PrintWriter;
import java.util.Locale;

import io.github.knotresolver.progress.Progress;

/**
 * Progress on standard error: one line every few seconds, so that a terminal
 * shows life and a log file stays short. Quick work prints nothing.
 */
final class ConsoleProgress implements Progress {

	private static final long INTERVAL_NANOS = 2_000_000_000L;

	private final PrintWriter err;
	private long lastNanos = System.nanoTime();
	private volatile boolean cancelled;

	ConsoleProgress(final PrintWriter err) {
		this.err = err;
	}

	@Override
	public synchronized void report(final String stage, final double fraction) {
		final long now = System.nanoTime();
		if (now - lastNanos < INTERVAL_NANOS || cancelled)
			return;
		lastNanos = now;
		err.printf(Locale.ROOT, "%s: %.0f %%%n", stage, 100 * fraction);
		err.flush();
	}

	@Override
	public synchronized void note(final String sentence) {
		err.println(sentence);
		err.flush();
	}

	@Override
	public boolean isCancelled() {
		return cancelled;
	}

	/** Asks the work to stop. */
	void cancel() {
		cancelled = true;
	}
}
