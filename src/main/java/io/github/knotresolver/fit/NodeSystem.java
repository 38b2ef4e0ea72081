
package io.github.knotresolver.fit;

import java.util.Arrays;

/**
 * Normal equations of the image term in node coordinates (x0, y0, x1, y1, ...):
 * the upper triangle of JᵀWJ and the vector JᵀWr.
 */
final class NodeSystem {

	final int size;
	final double[] matrix;
	final double[] vector;

	NodeSystem(final int nodes) {
		size = 2 * nodes;
		matrix = new double[size * size];
		vector = new double[size];
	}

	void clear() {
		Arrays.fill(matrix, 0);
		Arrays.fill(vector, 0);
	}

	/**
	 * Adds one pixel.
	 *
	 * @param nodes indices of the nodes it depends on, falling
	 * @param jacobian derivative of the model by x and y of these nodes
	 * @param count how many
	 * @param weight of the pixel
	 * @param residual picture minus model
	 */
	void add(final int[] nodes, final double[] jacobian, final int count, final double weight,
		final double residual) {
		for (int a = 0; a < count; a++) {
			final int row = 2 * nodes[a];
			final double wx = weight * jacobian[2 * a], wy = weight * jacobian[2 * a + 1];
			vector[row] += wx * residual;
			vector[row + 1] += wy * residual;
			// Nodes fall, so that the earlier entries are to the right in the matrix.
			for (int b = 0; b <= a; b++) {
				final int at = row * size + 2 * nodes[b];
				matrix[at] += wx * jacobian[2 * b];
				matrix[at + 1] += wx * jacobian[2 * b + 1];
				matrix[at + size] += wy * jacobian[2 * b];
				matrix[at + size + 1] += wy * jacobian[2 * b + 1];
			}
		}
	}
}
