package io.github.knotresolver.evaluate;

import java.util.Arrays;

/**
 * Gives rows to columns, one to one, so that the sum of their values is largest:
 * the Hungarian method with potentials (Kuhn 1955, doi:10.1002/nav.3800020109).
 * O(n² · m) for n rows and m columns, n at most m.
 */
final class Assignment {

	private final double[][] cost;
	private final int rows;
	private final int columns;
	private final double[] rowPotential;
	private final double[] columnPotential;
	/** The row of each column, both from 1; 0 for none. */
	private final int[] rowOf;

	private Assignment(final double[][] cost, final int columns) {
		this.cost = cost;
		this.rows = cost.length;
		this.columns = columns;
		rowPotential = new double[rows + 1];
		columnPotential = new double[columns + 1];
		rowOf = new int[columns + 1];
	}

	/**
	 * @param value of giving a row a column, rows first; 0 or more
	 * @param columns number of columns
	 * @return the column of each row; -1 if it gets none, or one of no value
	 */
	static int[] best(final double[][] value, final int columns) {
		final int[] given = new int[value.length];
		Arrays.fill(given, -1);
		if (value.length == 0 || columns == 0)
			return given;
		final boolean wide = value.length <= columns;
		final double[][] cost = new double[Math.min(value.length, columns)][Math.max(value.length,
			columns)];
		for (int i = 0; i < value.length; i++)
			for (int j = 0; j < columns; j++)
				cost[wide ? i : j][wide ? j : i] = -value[i][j];
		final int[] rowOf = new Assignment(cost, cost[0].length).solve();
		for (int j = 1; j < rowOf.length; j++) {
			if (rowOf[j] == 0)
				continue;
			final int i = wide ? rowOf[j] - 1 : j - 1, column = wide ? j - 1 : rowOf[j] - 1;
			if (value[i][column] > 0)
				given[i] = column;
		}
		return given;
	}

	private int[] solve() {
		for (int row = 1; row <= rows; row++)
			add(row);
		return rowOf;
	}

	/** Finds the cheapest alternating path from a row to a free column, and turns it round. */
	private void add(final int row) {
		final double[] slack = new double[columns + 1];
		final int[] before = new int[columns + 1];
		final boolean[] used = new boolean[columns + 1];
		Arrays.fill(slack, Double.POSITIVE_INFINITY);
		rowOf[0] = row;
		int column = 0;
		do {
			used[column] = true;
			column = step(column, slack, before, used);
		} while (rowOf[column] != 0);
		while (column != 0) {
			rowOf[column] = rowOf[before[column]];
			column = before[column];
		}
	}

	/** @return the next column of the path */
	private int step(final int column, final double[] slack, final int[] before,
		final boolean[] used) {
		final int row = rowOf[column];
		int next = 0;
		for (int j = 1; j <= columns; j++) {
			if (used[j])
				continue;
			final double reduced = cost[row - 1][j - 1] - rowPotential[row] - columnPotential[j];
			if (reduced < slack[j]) {
				slack[j] = reduced;
				before[j] = column;
			}
			if (next == 0 || slack[j] < slack[next])
				next = j;
		}
		final double delta = slack[next];
		for (int j = 0; j <= columns; j++)
			if (used[j]) {
				rowPotential[rowOf[j]] += delta;
				columnPotential[j] -= delta;
			} else
				slack[j] -= delta;
		return next;
	}
}
