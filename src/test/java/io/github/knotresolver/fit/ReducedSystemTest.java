
package io.github.knotresolver.fit;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;

import java.util.Random;

import org.apache.commons.math3.linear.Array2DRowRealMatrix;
import org.apache.commons.math3.linear.ArrayRealVector;
import org.apache.commons.math3.linear.CholeskyDecomposition;
import org.apache.commons.math3.linear.RealMatrix;
import org.junit.jupiter.api.Test;

class ReducedSystemTest {

	private static final int LINKS = 6;

	/** Where sums all but cancel, rounding is all that is left. */
	@Test
	void solvesWhereTheCouplingOfColumnAndRowCancels() {
		for (int seed = 0; seed < 200; seed++) {
			final NodeSystem nodes = cancelling(new Random(seed));
			final ReducedSystem system = new ReducedSystem(LINKS, true);
			final double[] x = {0, 1, 2, 3, 4, 5, 6}, y = {0, 0.5, 0.2, 1, 1.1, 0.7, 0};
			system.reduce(nodes, x, y, 1);
			assertNotNull(system.solve(1e-3), "seed " + seed);
		}
	}

	/** To the bit what commons-math finds, which cannot be cancelled. */
	@Test
	void choleskyIsThatOfTheLibrary() {
		for (int seed = 0; seed < 50; seed++) {
			final Random random = new Random(seed);
			final int n = 1 + random.nextInt(40);
			final RealMatrix factor = new Array2DRowRealMatrix(n, n);
			for (int i = 0; i < n; i++)
				for (int j = 0; j < n; j++)
					factor.setEntry(i, j, random.nextGaussian());
			final double[][] a = factor.multiply(factor.transpose()).getData();
			final double[] b = random.doubles(n).toArray();
			final double[] expected = new CholeskyDecomposition(new Array2DRowRealMatrix(a, true),
				1e-6, 1e-14).getSolver().solve(new ArrayRealVector(b)).toArray();
			assertArrayEquals(expected, Cholesky.solve(a, b), "seed " + seed);
		}
		assertNull(Cholesky.solve(new double[][]{{1, 2}, {2, 1}}, new double[]{1, 1}));
	}

	/** Random pixels, and one that makes columns and rows independent as a whole. */
	private static NodeSystem cancelling(final Random random) {
		final NodeSystem nodes = new NodeSystem(LINKS + 1, LINKS);
		double sum = 0;
		for (int i = 0; i < 100; i++) {
			final int node = 1 + random.nextInt(LINKS);
			final double[] slopes = random.doubles(4, -1, 1).toArray();
			nodes.add(new int[]{node, node - 1}, slopes, 2, 1, 0.1);
			sum += (slopes[0] + slopes[2]) * (slopes[1] + slopes[3]);
		}
		nodes.add(new int[]{0}, new double[]{1, -sum}, 1, 1, 0);
		return nodes;
	}
}
