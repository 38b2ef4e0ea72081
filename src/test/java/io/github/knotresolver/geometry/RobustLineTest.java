package io.github.knotresolver.geometry;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.stream.IntStream;

import org.junit.jupiter.api.Test;

class RobustLineTest {

	/** Of a quarter of the values anything is said; of many values not all are paired. */
	@Test
	void wrongValuesDoNotMoveTheLine() {
		for (final int n : new int[]{40, 100_000}) {
			final double[] at = IntStream.range(0, n).mapToDouble(i -> 2 * i).toArray();
			final double[] values = IntStream.range(0, n)
				.mapToDouble(i -> i % 4 == 1 ? 1e6 - 31 * i : 3 - 0.25 * at[i]).toArray();
			final RobustLine line = RobustLine.through(at, values);
			assertEquals(-0.25, line.slope(), 1e-9, n + " values");
			assertEquals(3, line.start(), 1e-4, n + " values");
			assertEquals(3 - 0.25 * 17, line.at(17), 1e-4, n + " values");
		}
	}

	@Test
	void fewValuesAreLevel() {
		assertEquals(new RobustLine(0, 0), RobustLine.through(new double[0], new double[0]));
		assertEquals(new RobustLine(5, 0), RobustLine.through(new double[]{7}, new double[]{5}));
	}
}
