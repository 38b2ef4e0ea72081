package io.github.knotresolver.evaluate;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Arrays;
import java.util.Random;

import org.junit.jupiter.api.Test;

class AssignmentTest {

	@Test
	void valueNotOrderDecides() {
		assertArrayEquals(new int[]{1, 0}, Assignment.best(new double[][]{{9, 8}, {9, 1}}, 2));
		assertArrayEquals(new int[]{-1, 0}, Assignment.best(new double[][]{{0, 0}, {3, 0}}, 2));
		assertArrayEquals(new int[]{-1, -1}, Assignment.best(new double[][]{{}, {}}, 0));
		assertArrayEquals(new int[]{}, Assignment.best(new double[][]{}, 3));
	}

	@Test
	void sumIsThatOfTheBestOfAllWays() {
		for (int seed = 0; seed < 500; seed++) {
			final Random random = new Random(seed);
			final int rows = 1 + random.nextInt(5), columns = 1 + random.nextInt(5);
			final double[][] value = new double[rows][columns];
			for (final double[] row : value)
				Arrays.setAll(row, j -> random.nextInt(4) == 0 ? 0 : random.nextInt(20));
			final int[] given = Assignment.best(value, columns);
			final boolean[] taken = new boolean[columns];
			double sum = 0;
			for (int i = 0; i < rows; i++)
				if (given[i] >= 0) {
					assertEquals(false, taken[given[i]], "seed " + seed);
					taken[given[i]] = true;
					sum += value[i][given[i]];
				}
			assertEquals(bruteForce(value, columns, 0, new boolean[columns]), sum, "seed " + seed);
		}
	}

	private static double bruteForce(final double[][] value, final int columns, final int row,
		final boolean[] taken) {
		if (row == value.length)
			return 0;
		double best = bruteForce(value, columns, row + 1, taken);
		for (int j = 0; j < columns; j++) {
			if (taken[j])
				continue;
			taken[j] = true;
			best = Math.max(best, value[row][j] + bruteForce(value, columns, row + 1, taken));
			taken[j] = false;
		}
		return best;
	}
}
