package io.github.knotresolver.progress;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicLong;
import java.util.stream.IntStream;

import org.junit.jupiter.api.Test;

class LanesTest {

	private final AtomicInteger running = new AtomicInteger(), most = new AtomicInteger();
	private final AtomicLong taken = new AtomicLong(), highest = new AtomicLong();

	@Test
	void neverMoreAtATimeThanLanes() {
		final List<Integer> done = Collections.synchronizedList(new ArrayList<>());
		try (Lanes lanes = new Lanes(3, 1000)) {
			for (int i = 0; i < 50; i++) {
				final int index = i;
				lanes.start(1, Progress.NONE, () -> {
					work(1);
					done.add(index);
				});
			}
			lanes.join(Progress.NONE);
			assertEquals(IntStream.range(0, 50).boxed().toList(), done.stream().sorted().toList());
		}
		assertTrue(most.get() <= 3, most + " at a time");
	}

	@Test
	void roomIsSharedAndWhatIsLargerRunsAlone() {
		try (Lanes lanes = new Lanes(8, 100)) {
			for (final long need : new long[]{40, 40, 40, 70, 30, 30, 30, 30, 99, 1, 1})
				lanes.start(need, Progress.NONE, () -> work(need));
			lanes.join(Progress.NONE);
			assertTrue(highest.get() <= 100, highest + " taken");
			final AtomicInteger beside = new AtomicInteger();
			lanes.start(10, Progress.NONE, () -> work(10));
			lanes.start(500, Progress.NONE, () -> beside.set(running.get()));
			lanes.start(1, Progress.NONE, () -> work(1));
			lanes.join(Progress.NONE);
			assertEquals(0, beside.get());
		}
	}

	@Test
	void twoRunAtTheSameTime() {
		final CountDownLatch both = new CountDownLatch(2);
		try (Lanes lanes = new Lanes(2, 2)) {
			for (int i = 0; i < 2; i++)
				lanes.start(1, Progress.NONE, () -> {
					both.countDown();
					try {
						both.await();
					} catch (final InterruptedException e) {
						throw new IllegalStateException(e);
					}
				});
			lanes.join(Progress.NONE);
		}
		assertEquals(0, both.getCount());
	}

	@Test
	void cancelStopsTheWaitAndTheWorkWhichTidiesUp() {
		final AtomicBoolean cancelled = new AtomicBoolean(), tidied = new AtomicBoolean();
		final CountDownLatch begun = new CountDownLatch(1);
		final Progress progress = new Progress() {

			@Override
			public void report(final String stage, final double fraction) {
			}

			@Override
			public boolean isCancelled() {
				return cancelled.get();
			}
		};
		assertThrows(CancelledException.class, () -> {
			try (Lanes lanes = new Lanes(1, 1)) {
				lanes.start(1, progress, () -> {
					begun.countDown();
					try {
						while (true)
							Cancellation.check();
					} finally {
						tidied.set(true);
					}
				});
				begun.await();
				cancelled.set(true);
				lanes.start(1, progress, () -> tidied.set(false));
			}
		});
		assertTrue(tidied.get());
	}

	@Test
	void failureOfOneIsThrownOnce() {
		final IllegalStateException failure = new IllegalStateException("x");
		assertSame(failure, assertThrows(IllegalStateException.class, () -> {
			try (Lanes lanes = new Lanes(2, 2)) {
				lanes.start(1, Progress.NONE, () -> {
					throw failure;
				});
				lanes.join(Progress.NONE);
			}
		}));
		assertThrows(IllegalArgumentException.class, () -> new Lanes(0, 1).close());
	}

	@Test
	void oneLineTellsOfAll() {
		final List<String> lines = new ArrayList<>();
		final ManyProgress many = new ManyProgress(new Progress() {

			@Override
			public void report(final String stage, final double fraction) {
				lines.add(stage + " | " + fraction);
			}

			@Override
			public boolean isCancelled() {
				return true;
			}
		}, 4, "movies");
		final ManyProgress.Part a = many.part("a.tif"), b = many.part("b.tif");
		a.report("Reading", 0.5);
		b.report("Fitting", 0);
		assertTrue(b.isCancelled());
		a.close();
		b.close();
		assertEquals(
			List.of("0 of 4 movies done (a.tif: Reading 50 %) | 0.0",
				"0 of 4 movies done (a.tif: Reading 50 %; b.tif: Fitting 0 %) | 0.0",
				"1 of 4 movies done (b.tif: Fitting 0 %) | 0.25", "2 of 4 movies done | 0.5"),
			lines);
	}

	private void work(final long need) {
		most.accumulateAndGet(running.incrementAndGet(), Math::max);
		highest.accumulateAndGet(taken.addAndGet(need), Math::max);
		Thread.yield();
		taken.addAndGet(-need);
		running.decrementAndGet();
	}
}
