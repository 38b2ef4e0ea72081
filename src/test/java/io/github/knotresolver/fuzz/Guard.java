package io.github.knotresolver.fuzz;

import java.io.PrintWriter;
import java.io.StringWriter;
import java.lang.management.ManagementFactory;
import java.time.LocalTime;
import java.util.Map;
import java.util.TreeMap;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.Consumer;
import java.util.function.LongSupplier;
import java.util.function.Supplier;

import io.github.knotresolver.model.UserException;
import io.github.knotresolver.progress.CancelledException;
import io.github.knotresolver.progress.Progress;

/**
 * Runs what an input starts, and tells what must not happen: any failure but a sentence for
 * people, and work without end. The first failure ends the test; with
 * {@code -Dfuzz.collect=true} all are counted by kind.
 */
public final class Guard {

	/** Work that computes longer than this, in nanoseconds, has no end. */
	private static final long LONGEST = TimeUnit.SECONDS.toNanos(5);

	/** Work that waits longer than this, in seconds, has none, either; a busy machine lets some wait. */
	private static final int LONGEST_WAIT = 600;

	private static final int FIRST_TOLD = 64;

	private static final boolean COLLECT = Boolean.getBoolean("fuzz.collect");

	private static final Map<String, Integer> COUNTS = new TreeMap<>();

	private static final Map<String, Integer> OUTCOMES = new TreeMap<>();

	private final String name;
	private final ExecutorService executor = Executors.newSingleThreadExecutor(this::worker);
	private volatile Thread thread;
	/** How many there were; every time that they are twice as many, it is told. */
	private long inputs;

	/** @param name what is tested, in messages */
	public Guard(final String name) {
		this.name = name;
	}

	private Thread worker(final Runnable work) {
		thread = new Thread(work, "fuzzed " + name);
		thread.setDaemon(true);
		return thread;
	}

	/**
	 * Runs work that is to end in a sentence or a result.
	 *
	 * @param input the input, for the message
	 * @param work reads it
	 */
	public void run(final Supplier<String> input, final Runnable work) {
		run(input, work, () -> ManagementFactory.getThreadMXBean().getThreadCpuTime(thread.getId()),
			() -> {
			});
	}

	/**
	 * The same for work on several threads that can be cancelled. Too long work is a failure; it is
	 * cancelled then, and must end soon.
	 *
	 * @param input the input, for the message
	 * @param work does it; the listener cancels
	 */
	public void runThreads(final Supplier<String> input, final Consumer<Progress> work) {
		final AtomicBoolean cancelled = new AtomicBoolean();
		run(input, () -> work.accept(new Cancelling(cancelled)),
			() -> ((com.sun.management.OperatingSystemMXBean) ManagementFactory
				.getOperatingSystemMXBean()).getProcessCpuTime(),
			() -> cancelled.set(true));
	}

	private record Cancelling(AtomicBoolean cancelled) implements Progress {

		@Override
		public void report(final String stage, final double fraction) {
			// Nobody looks.
		}

		@Override
		public boolean isCancelled() {
			return cancelled.get();
		}
	}

	private void run(final Supplier<String> input, final Runnable work, final LongSupplier clock,
		final Runnable cancel) {
		inputs++;
		if (COLLECT && inputs >= FIRST_TOLD && Long.bitCount(inputs) == 1)
			System.out.println(inputs + " inputs of " + name + " at " + LocalTime.now());
		final Future<?> running = executor.submit(work);
		final long start = thread == null ? 0 : clock.getAsLong();
		boolean late = false;
		for (int waited = 0;; waited++)
			try {
				running.get(1, TimeUnit.SECONDS);
				count(name + (late ? " cancelled" : " read"));
				return;
			} catch (final ExecutionException e) {
				judge(input, e.getCause());
				return;
			} catch (final TimeoutException e) {
				final long used = clock.getAsLong() - start;
				if (used > 2 * LONGEST || waited > LONGEST_WAIT) {
					running.cancel(true);
					throw endless(" without end\n  for " + input.get());
				}
				if (!late && used > LONGEST) {
					late = true;
					report(input, endless(" of more than 5 s"));
					cancel.run();
				}
			} catch (final InterruptedException e) {
				throw new IllegalStateException(e);
			}
	}

	/** Where the work is that takes so long. */
	private AssertionError endless(final String what) {
		final AssertionError endless = new AssertionError(name + ": work" + what);
		endless.setStackTrace(thread.getStackTrace());
		return endless;
	}

	private void judge(final Supplier<String> input, final Throwable thrown) {
		if (thrown instanceof CancelledException)
			return;
		if (!(thrown instanceof UserException)) {
			report(input, thrown);
			return;
		}
		count(name + " refused");
		final String sentence = thrown.getMessage();
		if (sentence == null || sentence.isBlank())
			report(input, new AssertionError("not a sentence: " + sentence, thrown));
	}

	/**
	 * A failure that must not be.
	 *
	 * @param input the input
	 * @param thrown what happened
	 */
	public void report(final Supplier<String> input, final Throwable thrown) {
		if (!COLLECT)
			throw new AssertionError(name + ": " + thrown + "\n  for " + input.get(), thrown);
		final String kind = name + ": " + thrown.getClass().getSimpleName() + " at "
			+ place(thrown);
		synchronized (COUNTS) {
			if (COUNTS.merge(kind, 1, Integer::sum) == 1) {
				final StringWriter trace = new StringWriter();
				thrown.printStackTrace(new PrintWriter(trace, true));
				System.out.println("NEW KIND " + kind + "\n  for " + input.get() + "\n" + trace);
			}
		}
	}

	/** Where in this program it happened. */
	private static String place(final Throwable thrown) {
		for (final StackTraceElement at : thrown.getStackTrace())
			if (at.getClassName().startsWith("io.github.knotresolver"))
				return at.toString();
		return thrown.getStackTrace().length == 0 ? "?" : thrown.getStackTrace()[0].toString();
	}

	/**
	 * Counts what became of an input.
	 *
	 * @param outcome what became of it
	 */
	public static void count(final String outcome) {
		synchronized (OUTCOMES) {
			OUTCOMES.merge(outcome, 1, Integer::sum);
		}
	}

	/** Fails if failures were counted. */
	public static void assertNone() {
		if (COLLECT)
			synchronized (OUTCOMES) {
				OUTCOMES.forEach((outcome, times) -> System.out.println(times + " " + outcome));
				OUTCOMES.clear();
			}
		synchronized (COUNTS) {
			final String counts = COUNTS.isEmpty() ? "" : COUNTS.toString();
			COUNTS.clear();
			if (!counts.isEmpty())
				throw new AssertionError(counts);
		}
	}
}
