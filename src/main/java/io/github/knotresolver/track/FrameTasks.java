package io.github.knotresolver.track;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Callable;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Future;

import io.github.knotresolver.progress.CancelledException;

/** Runs the same work for every frame, here or in parallel. */
final class FrameTasks {

	private FrameTasks() {
	}

	/** The results in the order of the tasks; the first failure is thrown on. */
	static <T> List<T> run(final List<Callable<T>> tasks,
		final Optional<ExecutorService> executor) {
		try {
			final List<T> results = new ArrayList<>();
			if (executor.isEmpty())
				for (final Callable<T> task : tasks)
					results.add(task.call());
			else
				for (final Future<T> future : executor.get().invokeAll(tasks))
					results.add(future.get());
			return results;
		} catch (final InterruptedException e) {
			Thread.currentThread().interrupt();
			throw new CancelledException();
		} catch (final ExecutionException e) {
			throw e.getCause() instanceof RuntimeException cause
				? cause
				: new IllegalStateException(e.getCause());
		} catch (final RuntimeException e) {
			throw e;
		} catch (final Exception e) {
			throw new IllegalStateException(e);
		}
	}
}
