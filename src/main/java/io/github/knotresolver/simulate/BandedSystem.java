
package io.github.knotresolver.simulate;

import java.util.Arrays;

/**
 * A symmetric banded system of linear equations, solved as L D Lᵀ without
 * pivoting. That is safe for saddle-point matrices in which every constraint
 * comes after the unknowns that it ties: all leading minors differ from zero
 * (compare Vanderbei 1995, doi:10.1137/0805005). O(n · bandwidth²).
 */
final class BandedSystem {

	private final int size;
	private final int band;

	/** Row by row: entry (i, i - band) to entry (i, i). */
	private final double[] lower;
	private final double[] rhs;

	/**
	 * @param size number of unknowns
	 * @param band number of diagonals below the main one
	 */
	BandedSystem(final int size, final int band) {
		this.size = size;
		this.band = band;
		lower = new double[size * (band + 1)];
		rhs = new double[size];
	}

	/** Sets the matrix and the right-hand side to zero. */
	void clear() {
		Arrays.fill(lower, 0);
		Arrays.fill(rhs, 0);
	}

	/** Adds to entry (i, j) and, by symmetry, to (j, i). */
	void add(final int i, final int j, final double value) {
		final int row = Math.max(i, j), column = Math.min(i, j);
		lower[row * (band + 1) + column - row + band] += value;
	}

	/** Adds to the right-hand side of equation i. */
	void addRight(final int i, final double value) {
		rhs[i] += value;
	}

	/** Replaces equation i by "unknown i is zero". */
	void hold(final int i) {
		for (int j = Math.max(0, i - band); j < i; j++)
			lower[i * (band + 1) + j - i + band] = 0;
		for (int j = i + 1; j <= Math.min(size - 1, i + band); j++)
			lower[j * (band + 1) + i - j + band] = 0;
		lower[i * (band + 1) + band] = 1;
		rhs[i] = 0;
	}

	/** Turns the matrix into L and D. To be called once, before solving. */
	void factor() {
		for (int i = 0; i < size; i++)
			factorRow(i);
	}

	private void factorRow(final int i) {
		final int row = i * (band + 1) + band - i;
		final int first = Math.max(0, i - band);
		for (int j = first; j < i; j++) {
			final int other = j * (band + 1) + band - j;
			double sum = lower[row + j];
			for (int k = Math.max(first, j - band); k < j; k++)
				sum -= lower[row + k] * lower[other + k];
			lower[row + j] = sum;
		}
		double pivot = lower[row + i];
		for (int j = first; j < i; j++) {
			final double scaled = lower[row + j];
			lower[row + j] = scaled / lower[j * (band + 1) + band];
			pivot -= scaled * lower[row + j];
		}
		lower[row + i] = pivot;
	}

	/**
	 * Solves the factored system for the right-hand side that was added up since
	 * the last call of {@link #clear()} or {@link #clearRight()}.
	 *
	 * @return the unknowns; the right-hand side is overwritten by them
	 */
	double[] solve() {
		for (int i = 0; i < size; i++) {
			final int row = i * (band + 1) + band - i;
			for (int j = Math.max(0, i - band); j < i; j++)
				rhs[i] -= lower[row + j] * rhs[j];
		}
		for (int i = 0; i < size; i++)
			rhs[i] /= lower[i * (band + 1) + band];
		for (int i = size - 1; i >= 0; i--) {
			final int row = i * (band + 1) + band - i;
			for (int j = Math.max(0, i - band); j < i; j++)
				rhs[j] -= lower[row + j] * rhs[i];
		}
		return rhs;
	}

	/** Sets the right-hand side alone to zero. */
	void clearRight() {
		Arrays.fill(rhs, 0);
	}
}
