
package io.github.knotresolver.progress;

/**
 * Lets inner loops stop that know nothing of who asked for the work: a distance of curves, the
 * thinning of a mask, a step of a fit. The work that a thread does at the moment has one
 * {@link Progress}; {@link Workers} carry it over to their threads. A loop that may take longer than
 * a blink calls {@link #check()} once a round, which costs some nanoseconds.
 */
public final class Cancellation {

	/**
	 * Work of a thread.
	 *
	 * @param <T> what it gives
	 * @param <E> how it may fail
	 */
	@FunctionalInterface
	public interface Work<T, E extends Exception> {

		/**
		 * Does it.
		 *
		 * @return what it gives
		 * @throws E if it fails
		 */
		T run() throws E;
	}

	private static final ThreadLocal<Progress> PRESENT = ThreadLocal
		.withInitial(() -> Progress.NONE);

	private Cancellation() {
	}

	/**
	 * Does work in this thread; all checks in it ask the given listener.
	 *
	 * @param <T> what it gives
	 * @param <E> how it may fail
	 * @param progress may cancel
	 * @param work the work
	 * @return what it gives
	 * @throws E if it fails
	 * @throws CancelledException if the user asked to stop
	 */
	public static <T, E extends Exception> T during(final Progress progress, final Work<T, E> work)
		throws E {
		final Progress before = PRESENT.get();
		PRESENT.set(progress);
		try {
			return work.run();
		} finally {
			PRESENT.set(before);
		}
	}

	/** @return the listener of this thread's work, for threads that do a part of it */
	public static Progress present() {
		return PRESENT.get();
	}

	/** @throws CancelledException if the user asked this thread's work to stop */
	public static void check() {
		PRESENT.get().checkCancelled();
	}
}
