package io.github.knotresolver.progress;

import java.util.concurrent.atomic.AtomicInteger;

/**
 * Lets pieces of work run at the same time, each in a thread of its own, as long as there is a lane
 * and room for it. Pieces begin in the order in which they are given; one that needs more room than
 * there is runs when all others have ended. Given by one thread only.
 *
 * <pre>
 * try (Lanes lanes = new Lanes(2, bytes)) {
 * 	for (final Movie movie : movies)
 * 		lanes.start(movie.bytes(), progress, () -&gt; work(movie));
 * 	lanes.join(progress);
 * }
 * </pre>
 */
public final class Lanes implements AutoCloseable {

	/** How long a wish to stop may go unnoticed, in ms. */
	private static final long LOOK_MILLISECONDS = 50;

	private final int lanes;
	private final long room;
	private final AtomicInteger started = new AtomicInteger();
	private int running;
	private long taken;
	private Throwable failure;

	/**
	 * @param lanes most pieces at a time, at least 1
	 * @param room what all of them may need together
	 */
	public Lanes(final int lanes, final long room) {
		if (lanes < 1)
			throw new IllegalArgumentException("lanes must be at least 1, but is " + lanes + ".");
		this.lanes = lanes;
		this.room = room;
	}

	/**
	 * Waits until there is a lane and room, and begins a piece of work.
	 *
	 * @param need the room that it needs
	 * @param progress may cancel the wait, and all checks in the work
	 * @param work what to do
	 * @throws CancelledException if the user asked to stop
	 */
	public void start(final long need, final Progress progress, final Runnable work) {
		synchronized (this) {
			while (running == lanes || running > 0 && need > room - taken)
				await(progress);
			requireNoFailure();
			progress.checkCancelled();
			running++;
			taken += need;
		}
		final Thread thread = new Thread(() -> run(need, progress, work),
			"KnotResolver lane " + started.incrementAndGet());
		thread.setDaemon(true);
		thread.start();
	}

	private void run(final long need, final Progress progress, final Runnable work) {
		Throwable thrown = null;
		try {
			Cancellation.during(progress, () -> {
				work.run();
				return null;
			});
		} catch (final RuntimeException | Error e) {
			thrown = e;
		}
		synchronized (this) {
			running--;
			taken -= need;
			// That the user asked to stop is told by the one who asks for it, too.
			if (failure == null || failure instanceof CancelledException)
				failure = thrown == null ? failure : thrown;
			notifyAll();
		}
	}

	/**
	 * Waits until all pieces have ended.
	 *
	 * @param progress may cancel the wait
	 * @throws CancelledException if the user asked to stop
	 */
	public synchronized void join(final Progress progress) {
		while (running > 0)
			await(progress);
		requireNoFailure();
	}

	private void await(final Progress progress) {
		requireNoFailure();
		progress.checkCancelled();
		try {
			wait(LOOK_MILLISECONDS);
		} catch (final InterruptedException e) {
			Thread.currentThread().interrupt();
			throw new CancelledException();
		}
	}

	private void requireNoFailure() {
		if (failure instanceof RuntimeException e)
			throw e;
		if (failure instanceof Error e)
			throw e;
	}

	/** Waits for what runs: pieces that were asked to stop still tidy up. */
	@Override
	public synchronized void close() {
		boolean interrupted = false;
		while (running > 0)
			try {
				wait();
			} catch (final InterruptedException e) {
				interrupted = true;
			}
		if (interrupted)
			Thread.currentThread().interrupt();
	}
}
