package io.github.knotresolver.imagej;

import java.io.IOException;
import java.util.List;
import java.util.concurrent.Callable;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;

import io.github.knotresolver.progress.Cancellation;
import io.github.knotresolver.progress.Progress;

/** Does independent work at the same time. */
final class Together {

	/** Work that may fail on the disk. */
	@FunctionalInterface
	interface Task {

		void run() throws IOException;
	}

	private Together() {
	}

	/**
	 * Returns when all tasks have ended, one way or another.
	 *
	 * @param tasks what to do
	 * @throws IOException the first failure in the order of the tasks
	 */
	static void run(final Task... tasks) throws IOException {
		final ExecutorService pool = Executors.newFixedThreadPool(tasks.length);
		try {
			final List<Callable<Void>> calls = List.of(tasks).stream().map(Together::call).toList();
			for (final Future<Void> future : pool.invokeAll(calls))
				future.get();
		} catch (final ExecutionException e) {
			throw failure(e.getCause());
		} catch (final InterruptedException e) {
			Thread.currentThread().interrupt();
			throw new IOException("the work was interrupted", e);
		} finally {
			pool.shutdown();
		}
	}

	private static Callable<Void> call(final Task task) {
		final Progress present = Cancellation.present();
		return () -> Cancellation.during(present, () -> {
			task.run();
			return null;
		});
	}

	private static IOException failure(final Throwable cause) {
		if (cause instanceof IOException e)
			return e;
		if (cause instanceof RuntimeException e)
			throw e;
		throw (Error) cause;
	}
}
