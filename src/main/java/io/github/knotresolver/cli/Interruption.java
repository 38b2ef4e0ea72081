package io.github.knotresolver.cli;

import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;

/**
 * Ctrl-C: the work is asked to stop and the process ends when it has cleaned
 * up. Java itself then gives the exit status 130.
 */
final class Interruption {

	private static final long PATIENCE_SECONDS = 5;

	private final CountDownLatch finished = new CountDownLatch(1);

	/**
	 * @param stop asks the work to stop
	 * @return the listener, to be told when the work has ended
	 */
	static Interruption listen(final Runnable stop) {
		final Interruption interruption = new Interruption();
		Runtime.getRuntime().addShutdownHook(new Thread(() -> {
			stop.run();
			interruption.await();
		}, "clean up"));
		return interruption;
	}

	/** The work has ended, one way or another. */
	void finished() {
		finished.countDown();
	}

	private void await() {
		try {
			finished.await(PATIENCE_SECONDS, TimeUnit.SECONDS);
		} catch (final InterruptedException e) {
			Thread.currentThread().interrupt();
		}
	}
}
