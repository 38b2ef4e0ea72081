
package io.github.knotresolver.simulate;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;

import java.util.Random;

import org.apache.commons.math3.linear.Array2DRowRealMatrix;
import org.apache.commons.math3.linear.ArrayRealVector;
import org.apache.commons.math3.linear.LUDecomposition;
import org.apache.commons.math3.linear.RealMatrix;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class BandedSystemTest {

	@ParameterizedTest
	@ValueSource(ints = {1, 2, 5, 12, 30})
	void solvesAsAPivotingDenseSolverDoes(final int size) {
		final Random random = new Random(size);
		final int band = 3;
		final BandedSystem banded = new BandedSystem(size, band);
		final RealMatrix dense = new Array2DRowRealMatrix(size, size);
		final double[] right = new double[size];
		for (int i = 0; i < size; i++) {
			right[i] = random.nextGaussian();
			banded.addRight(i, right[i]);
			for (int j = Math.max(0, i - band); j <= i; j++) {
				final double value = random.nextGaussian()
					+ (i == j ? 8 * (i % 3 == 2 ? -1 : 1) : 0);
				banded.add(j, i, value);
				dense.setEntry(i, j, value);
				dense.setEntry(j, i, value);
			}
		}
		final double[] expected = new LUDecomposition(dense).getSolver()
			.solve(new ArrayRealVector(right)).toArray();
		banded.factor();
		assertArrayEquals(expected, banded.solve(), 1e-9, "seed " + size);
	}

	@ParameterizedTest
	@ValueSource(ints = {0, 1, 3})
	void aHeldUnknownIsZeroAndTheOthersSolveWithoutIt(final int held) {
		final BandedSystem s = new BandedSystem(4, 2);
		final double[][] m = {{4, 1, 2, 0}, {1, 5, 1, 1}, {2, 1, 6, 2}, {0, 1, 2, 7}};
		final RealMatrix dense = new Array2DRowRealMatrix(m);
		final double[] right = {1, 2, 3, 4};
		for (int i = 0; i < 4; i++) {
			s.addRight(i, right[i]);
			for (int j = Math.max(0, i - 2); j <= i; j++)
				s.add(i, j, m[i][j]);
			dense.setEntry(held, i, i == held ? 1 : 0);
			dense.setEntry(i, held, i == held ? 1 : 0);
		}
		right[held] = 0;
		s.hold(held);
		s.factor();
		assertArrayEquals(
			new LUDecomposition(dense).getSolver().solve(new ArrayRealVector(right)).toArray(),
			s.solve(), 1e-12);
	}
}
