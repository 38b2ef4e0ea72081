
package io.github.knotresolver.fit;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.concurrent.atomic.AtomicInteger;

import org.junit.jupiter.api.Test;

import io.github.knotresolver.progress.CancelledException;
import io.github.knotresolver.progress.Progress;

class SimplexSearchTest {

	private static final double[] GUESS = {1, 1}, SPREAD = {0.5, 0.5};

	@Test
	void findsTheLowestPointOfABowl() {
		final double[] lowest = search(500, Progress.NONE)
			.lowest(p -> Math.pow(p[0] - 3, 2) + Math.pow(p[1] + 2, 2), GUESS, SPREAD);
		assertArrayEquals(new double[]{3, -2}, lowest, 1e-3);
	}

	@Test
	void givesTheLowestPointSeenWhereThereIsNoEnd() {
		final AtomicInteger count = new AtomicInteger();
		final double[] lowest = search(60, Progress.NONE).lowest(p -> {
			count.incrementAndGet();
			return -p[0];
		}, GUESS, SPREAD);
		assertEquals(60, count.get());
		assertTrue(lowest[0] > 10, "" + lowest[0]);
	}

	@Test
	void givesTheGuessWhereNothingIsDefined() {
		assertArrayEquals(GUESS, search(60, Progress.NONE).lowest(p -> Double.NaN, GUESS, SPREAD));
	}

	@Test
	void asksBeforeEveryEvaluationWhetherToStop() {
		final AtomicInteger evaluations = new AtomicInteger();
		final Progress stop = new Progress() {

			@Override
			public void report(final String stage, final double fraction) {
			}

			@Override
			public boolean isCancelled() {
				return evaluations.get() >= 7;
			}
		};
		assertThrows(CancelledException.class, () -> search(500, stop).lowest(p -> {
			evaluations.incrementAndGet();
			return Math.abs(p[0]);
		}, GUESS, SPREAD));
		assertEquals(7, evaluations.get());
	}

	private static SimplexSearch search(final int evaluations, final Progress progress) {
		return new SimplexSearch(1e-10, 1e-12, evaluations, progress);
	}
}
