package io.github.knotresolver.fit;

import java.util.Arrays;

/**
 * Normal equations of the image term in node coordinates (x0, y0, x1, y1, ...): the upper
 * triangle of JᵀWJ, as far as a pixel can couple nodes, and the vector JᵀWr.
 */
final class NodeSystem {

	final int size;
	final double[] vector;

	/** Row by row, each from its own node's first column on. */
	private final double[] matrix;
	private final int stride;

	/**
	 * @param nodes number of nodes
	 * @param reach how many nodes farther on a pixel of a node may still touch: at least 1,
	 *          at most {@code nodes - 1}
	 */
	NodeSystem(final int nodes, final int reach) {
		size = 2 * nodes;
		stride = 2 * (reach + 1);
		matrix = new double[size * stride];
		vector = new double[size];
	}

	void clear() {
		for (int row = 0; row < size; row++)
			Arrays.fill(matrix, row * stride, row * stride + Math.min(stride, size - (row & ~1)),
				0);
		Arrays.fill(vector, 0);
	}

	/**
	 * @param row from 0
	 * @param column of the same node or a later one within reach
	 * @return the entry
	 */
	double get(final int row, final int column) {
		return matrix[row * stride + column - (row & ~1)];
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
				final int at = row * stride + 2 * (nodes[b] - nodes[a]);
				matrix[at] += wx * jacobian[2 * b];
				matrix[at + 1] += wx * jacobian[2 * b + 1];
				matrix[at + stride] += wy * jacobian[2 * b];
				matrix[at + stride + 1] += wy * jacobian[2 * b + 1];
			}
		}
	}
}
