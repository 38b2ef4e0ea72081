package io.github.knotresolver;

import io.github.knotresolver.progress.Progress;

/** A user who has pressed cancel. */
public final class CancelledProgress implements Progress {

	@Override
	public void report(final String stage, final double fraction) {
		// Nobody listens any more.
	}

	@Override
	public boolean isCancelled() {
		return true;
	}
}
