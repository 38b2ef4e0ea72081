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

	/** Begins work of which no stage is told; as {@link #start(Consumer, Consumer)}. */
	void start(final Consumer<Progress> work) {
		// Too short to be watched.
		start(stage -> {
		}, work);
	}

	/**
	 * Begins; returns at once. After {@link #close()} nothing is begun.
	 *
	 * @param stages hears of the work's stages as long as it counts
	 * @param work asks its progress whether it still counts before it tells anybody its result
	 */
	void start(final Consumer<String> stages, final Consumer<Progress> work) {
		final int number = latest.incrementAndGet();
		final Progress progress = new Progress() {

			@Override
			public void report(final String stage, final double fraction) {
				if (!isCancelled())
					stages.accept(stage);
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
