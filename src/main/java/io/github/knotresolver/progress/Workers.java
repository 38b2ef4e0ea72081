package io.github.knotresolver.progress;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Callable;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.IntFunction;
import java.util.stream.IntStream;

/**
 * Threads for work on many frames: all that work on a movie come from here, as many as
 * {@code --threads} says. Results come in the order of the tasks, so that they do not depend
 * on the number of threads.
 * <p>
 * Work that knows nothing of who asked for it, such as a measurement, takes {@link #present()}.
 */
public final class Workers implements AutoCloseable {

	/** No threads of its own: all work is done by the thread that asks. */
	public static final Workers HERE = new Workers();

	private static final ThreadLocal<Workers> PRESENT = ThreadLocal.withInitial(() -> HERE);

	private final Optional<ExecutorService> executor;
	private final int threads;

	private Workers() {
		executor = Optional.empty();
		threads = 1;
	}

	/**
	 * @param threads number of threads, at least 1
	 */
	public Workers(final int threads) {
		this.threads = threads;
		executor = Optional.of(Executors.newFixedThreadPool(threads, work -> {
			final Thread thread = new Thread(work, "KnotResolver worker");
			thread.setDaemon(true);
			return thread;
		}));
	}

	/** @return the number of tasks that are done at a time */
	public int threads() {
		return threads;
	}

	/** @return as many threads as this computer does at a time, for work without {@code --threads} */
	public static Workers ofThisComputer() {
		return new Workers(Runtime.getRuntime().availableProcessors());
	}

	/**
	 * Does work in this thread; all of it that asks for {@link #present()} gets these.
	 *
	 * @param <T> what it gives
	 * @param <E> how it may fail
	 * @param work the work
	 * @return what it gives
	 * @throws E if it fails
	 */
	public <T, E extends Exception> T during(final Cancellation.Work<T, E> work) throws E {
		final Workers before = PRESENT.get();
		PRESENT.set(this);
		try {
			return work.run();
		} finally {
			PRESENT.set(before);
		}
	}

	/**
	 * @return the threads of this thread's work; {@link #HERE} if there are none, and in the
	 *         threads themselves, so that none waits for another
	 */
	public static Workers present() {
		return PRESENT.get();
	}

	/**
	 * Does a task for each of 0..count-1.
	 *
	 * @param <T> what a task gives
	 * @param count number of tasks
	 * @param task gives the result for an index
	 * @return the results in order
	 * @throws CancelledException if the thread was interrupted
	 */
	public <T> List<T> map(final int count, final IntFunction<T> task) {
		if (executor.isEmpty())
			return IntStream.range(0, count).mapToObj(task).toList();
		final Progress present = Cancellation.present();
		final List<Callable<T>> tasks = new ArrayList<>();
		for (int i = 0; i < count; i++) {
			final int index = i;
			tasks.add(() -> Cancellation.during(present, () -> task.apply(index)));
		}
		return run(tasks, executor.get());
	}

	/**
	 * Does a task for each of 0..count-1, tells how many are done and stops if asked to.
	 *
	 * @param <T> what a task gives
	 * @param stage what is being done, in a few words
	 * @param progress told and asked
	 * @param count number of tasks
	 * @param task gives the result for an index
	 * @return the results in order
	 * @throws CancelledException if the user asked to stop
	 */
	public <T> List<T> map(final String stage, final Progress progress, final int count,
		final IntFunction<T> task) {
		final AtomicInteger done = new AtomicInteger();
		return map(count, i -> {
			progress.checkCancelled();
			final T result = Cancellation.during(progress, () -> task.apply(i));
			progress.report(stage, (double) done.incrementAndGet() / count);
			return result;
		});
	}

	private static <T> List<T> run(final List<Callable<T>> tasks, final ExecutorService executor) {
		try {
			final List<T> results = new ArrayList<>();
			for (final Future<T> future : executor.invokeAll(tasks))
				results.add(future.get());
			return results;
		} catch (final InterruptedException e) {
			Thread.currentThread().interrupt();
			throw new CancelledException();
		} catch (final ExecutionException e) {
			if (e.getCause() instanceof RuntimeException cause)
				throw cause;
			if (e.getCause() instanceof Error error)
				throw error;
			throw new IllegalStateException(e.getCause());
		}
	}

	/** Stops the threads; work that goes on is interrupted. */
	@Override
	public void close() {
		executor.ifPresent(ExecutorService::shutdownNow);
	}
}
