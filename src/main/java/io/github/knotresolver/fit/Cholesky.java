package io.github.knotresolver.fit;

import io.github.knotresolver.progress.Cancellation;

/**
 * Solves A x = b for a symmetric, positive definite A, by its factors L Lᵀ (Golub and Van Loan 2013, Matrix
 * Computations, algorithm 4.2.2). Other than a library's it may be cancelled once a row, which counts
 * for filaments of thousands of pixels. O(n³) in time, nothing beside the matrix in memory.
 */
final class Cholesky {

	/** Pivots up to this are 0. */
	private static final double LEAST_PIVOT = 1e-14;

	private Cholesky() {
	}

	/**
	 * @param a the matrix, n x n, of which the upper triangle is read; becomes Lᵀ
	 * @param b the right side, n
	 * @return x, or {@code null} if the matrix is not positive definite
	 */
	static double[] solve(final double[][] a, final double[] b) {
		return isFactored(a) ? substituted(a, b) : null;
	}

	private static boolean isFactored(final double[][] a) {
		final int n = a.length;
		for (int q = 0; q < n; q++) {
			Cancellation.check();
			final double[] row = a[q];
			int i = 0;
			for (; i + 4 <= q; i += 4)
				subtractFour(row, a, i, q);
			for (; i < q; i++)
				subtract(row, a[i], q);
			if (row[q] <= LEAST_PIVOT)
				return false;
			row[q] = Math.sqrt(row[q]);
			final double inverse = 1 / row[q];
			for (int p = q + 1; p < n; p++)
				row[p] *= inverse;
		}
		return true;
	}

	private static void subtract(final double[] row, final double[] above, final int from) {
		final double factor = above[from];
		for (int p = from; p < row.length; p++)
			row[p] -= factor * above[p];
	}

	/** The same for four rows, in order, by which a row is read and written once for all four. */
	private static void subtractFour(final double[] row, final double[][] a, final int first,
		final int from) {
		final double[] a0 = a[first], a1 = a[first + 1], a2 = a[first + 2], a3 = a[first + 3];
		final double f0 = a0[from], f1 = a1[from], f2 = a2[from], f3 = a3[from];
		for (int p = from; p < row.length; p++)
			row[p] = row[p] - f0 * a0[p] - f1 * a1[p] - f2 * a2[p] - f3 * a3[p];
	}

	private static double[] substituted(final double[][] upper, final double[] b) {
		final double[] x = b.clone();
		for (int j = 0; j < x.length; j++) {
			x[j] /= upper[j][j];
			for (int i = j + 1; i < x.length; i++)
				x[i] -= x[j] * upper[j][i];
		}
		for (int j = x.length - 1; j >= 0; j--) {
			x[j] /= upper[j][j];
			for (int i = 0; i < j; i++)
				x[i] -= x[j] * upper[i][j];
		}
		return x;
	}
}
