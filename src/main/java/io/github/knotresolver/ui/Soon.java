package io.github.knotresolver.ui;

import java.util.concurrent.atomic.AtomicBoolean;

import javax.swing.SwingUtilities;

/** Work for the thread of events, done once however often it was asked for meanwhile. */
final class Soon implements Runnable {

	private final AtomicBoolean asked = new AtomicBoolean();
	private final Runnable work;

	/** @param work done in the thread of events */
	Soon(final Runnable work) {
		this.work = work;
	}

	/** Asks for it, from any thread; returns at once. */
	@Override
	public void run() {
		if (!asked.getAndSet(true))
			SwingUtilities.invokeLater(() -> {
				asked.set(false);
				work.run();
			});
	}
}
