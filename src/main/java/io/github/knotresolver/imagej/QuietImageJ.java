package io.github.knotresolver.imagej;

import java.awt.GraphicsEnvironment;
import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.util.concurrent.Callable;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.FutureTask;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;

import io.github.knotresolver.progress.CancelledException;
import io.github.knotresolver.progress.Progress;

/**
 * Calls readers of files so that a person can stop them, whatever is in the file, and
 * that what ImageJ prints meanwhile goes neither to standard output nor to
 * standard error, when there is no window it could go to. What others print at the same time does.
 */
final class QuietImageJ {

	private static final int LOOK_MILLISECONDS = 50;

	/**
	 * @param <T> what the work gives
	 * @param value what it gave
	 * @param printed what was printed meanwhile
	 */
	record Printed<T>(T value, String printed) {
	}

	private QuietImageJ() {
	}

	/**
	 * @param <T> what the work gives
	 * @param work calls ImageJ; if it does not end it is left to itself
	 * @param progress may cancel
	 * @return what it gave and printed
	 * @throws Exception what the work threw
	 */
	static <T> Printed<T> call(final Callable<T> work, final Progress progress) throws Exception {
		if (!GraphicsEnvironment.isHeadless())
			return new Printed<>(patiently(work, progress), "");
		final ByteArrayOutputStream printed = new ByteArrayOutputStream();
		try (PrintStream own = new PrintStream(printed, true, StandardCharsets.UTF_8)) {
			final T value = patiently(() -> {
				ThreadPrinting.to(own);
				return work.call();
			}, progress);
			return new Printed<>(value, printed.toString(StandardCharsets.UTF_8));
		}
	}

	private static <T> T patiently(final Callable<T> work, final Progress progress)
		throws Exception {
		final FutureTask<T> task = new FutureTask<>(work);
		final Thread reader = new Thread(task, "Reading a movie");
		reader.setDaemon(true);
		reader.start();
		try {
			while (true)
				try {
					return task.get(LOOK_MILLISECONDS, TimeUnit.MILLISECONDS);
				} catch (final TimeoutException e) {
					progress.checkCancelled();
				}
		} catch (final InterruptedException e) {
			Thread.currentThread().interrupt();
			throw new CancelledException();
		} catch (final ExecutionException e) {
			if (e.getCause() instanceof Error error)
				throw error;
			throw (Exception) e.getCause();
		} finally {
			reader.interrupt();
		}
	}
}
