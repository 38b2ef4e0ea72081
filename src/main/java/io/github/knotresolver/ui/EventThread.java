package io.github.knotresolver.ui;

import java.awt.EventQueue;
import java.lang.reflect.InvocationTargetException;

import io.github.knotresolver.progress.CancelledException;

/** Windows are made and changed by the thread of events. */
final class EventThread {

	private EventThread() {
	}

	/**
	 * Does work in the thread of events, and waits for it.
	 *
	 * @throws CancelledException if this thread is asked to stop
	 */
	static void run(final Runnable work) {
		try {
			if (EventQueue.isDispatchThread())
				work.run();
			else
				EventQueue.invokeAndWait(work);
		} catch (final InterruptedException e) {
			Thread.currentThread().interrupt();
			throw new CancelledException();
		} catch (final InvocationTargetException e) {
			if (e.getCause() instanceof RuntimeException cause)
				throw cause;
			throw new IllegalStateException(e.getCause());
		}
	}
}
