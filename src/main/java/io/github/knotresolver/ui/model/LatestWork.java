package io.github.knotresolver.ui.model;

import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.Consumer;

import io.github.knotresolver.progress.Cancellation;
import io.github.knotresolver.progress.CancelledException;
import io.github.knotresolver.progress.Progress;

/**
 * Work in a thread of its own, of which only the latest counts: new work stops that before, which is
 * told so by its {@link Progress}.
 */
final class LatestWork implements AutoCloseable {

	private final AtomicInteger latest = new AtomicInteger();
	private final ExecutorService thread;

	/** @param name of the thread */
	LatestWork(final String name) {
		thread = Executors.newSingleThreadExecutor(work -> {
			final Thread t = new Thread(work, name);
			t.setDaemon(true);
			return t;
		});
	}

	/**
	 * Begins; returns at once. After {@link #close()} nothing is begun.
	 *
	 * @param work asks its progress whether it still counts before it tells anybody its result
	 */
	void start(final Consumer<Progress> work) {
		final int number = latest.incrementAndGet();
		final Progress progress = new Progress() {

			@Override
			public void report(final String stage, final double fraction) {
				// Too short to be watched.
			}

			@Override
			public boolean isCancelled() {
				return latest.get() != number;
			}
		};
		if (!thread.isShutdown())
			thread.execute(() -> run(work, progress));
	}

	private static void run(final Consumer<Progress> work, final Progress progress) {
		try {
			progress.checkCancelled();
			Cancellation.during(progress, () -> {
				work.accept(progress);
				return null;
			});
		} catch (final CancelledException e) {
			// Other work counts, or nobody listens any more.
		}
	}

	/** What is being done does not count any more. */
	void stop() {
		latest.incrementAndGet();
	}

	@Override
	public void close() {
		stop();
		thread.shutdown();
	}
}
