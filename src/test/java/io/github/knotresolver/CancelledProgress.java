package io.github.knotresolver;

import java.util.concurrent.atomic.AtomicInteger;

import io.github.knotresolver.progress.Progress;

/** A user who has pressed cancel, or will do so soon. */
public final class CancelledProgress implements Progress {

	private final AtomicInteger patience;

	/** It was pressed before the work began. */
	public CancelledProgress() {
		this(0);
	}

	/** @param patience so often the work may ask whether to stop before it must */
	public CancelledProgress(final int patience) {
		this.patience = new AtomicInteger(patience);
	}

	@Override
	public void report(final String stage, final double fraction) {
		// Nobody listens any more.
	}

	@Override
	public boolean isCancelled() {
		return patience.getAndUpdate(n -> Math.max(0, n - 1)) == 0;
	}
}
