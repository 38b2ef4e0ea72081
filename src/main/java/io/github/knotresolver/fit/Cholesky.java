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
		for (int i = 0; i < n; i++) {
			Cancellation.check();
			final double[] row = a[i];
			if (row[i] <= LEAST_PIVOT)
				return false;
			row[i] = Math.sqrt(row[i]);
			final double inverse = 1 / row[i];
			for (int q = n - 1; q > i; q--) {
				row[q] *= inverse;
				final double[] below = a[q];
				for (int p = q; p < n; p++)
					below[p] -= row[q] * row[p];
			}
		}
		return true;
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
