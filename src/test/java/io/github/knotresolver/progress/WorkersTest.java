package io.github.knotresolver.progress;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.stream.IntStream;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class WorkersTest {

	private static final List<Integer> SQUARES = IntStream.range(0, 100).map(i -> i * i).boxed()
		.toList();

	@ParameterizedTest
	@ValueSource(ints = {1, 2, 8})
	void resultsComeInOrder(final int threads) {
		try (Workers workers = new Workers(threads)) {
			assertEquals(SQUARES, workers.map(100, i -> i * i));
		}
		assertEquals(SQUARES, Workers.HERE.map(100, i -> i * i));
	}

	@Test
	void theFirstFailureComesThrough() {
		try (Workers workers = new Workers(3)) {
			final String message = assertThrows(IllegalArgumentException.class,
				() -> workers.map(9, i -> {
					if (i >= 4)
						throw new IllegalArgumentException("task " + i);
					return i;
				})).getMessage();
			assertEquals("task 4", message);
		}
	}

	@Test
	void tellsHowManyAreDoneAndStopsWhenAsked() {
		final List<Double> told = new CopyOnWriteArrayList<>();
		final Progress progress = new Progress() {

			@Override
			public void report(final String stage, final double fraction) {
				told.add(fraction);
			}

			@Override
			public boolean isCancelled() {
				return told.size() >= 3;
			}
		};
		assertThrows(CancelledException.class,
			() -> Workers.HERE.map("counting", progress, 4, i -> i));
		assertEquals(List.of(0.25, 0.5, 0.75), told);
	}
}
