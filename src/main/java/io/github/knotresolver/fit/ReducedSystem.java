
package io.github.knotresolver.fit;

/**
 * The dense system, for pixels that couple any nodes. As every node behind a link moves
 * alike, suffix sums over the node matrix reduce it in O(n²); a solution is O(n³).
 */
final class ReducedSystem implements StepSystem {

	/** Added to a diagonal entry before it is damped. */
	static final double LEAST_DAMPED = 1e-3;

	private final int links;
	private final boolean freeLength;
	private final double[][] blocks;
	private final double[] pull;
	private final double[][] damped;

	/** Symmetric matrix of the unknowns: its upper triangle. */
	final double[][] matrix;
	/** Right-hand side. */
	final double[] vector;

	ReducedSystem(final int links, final boolean freeLength) {
		this.links = links;
		this.freeLength = freeLength;
		blocks = new double[2 * (links + 1)][2 * (links + 1)];
		pull = new double[2 * (links + 1)];
		final int size = links + 2 + (freeLength ? 1 : 0);
		matrix = new double[size][size];
		damped = new double[size][size];
		vector = new double[size];
	}

	@Override
	public void reduce(final NodeSystem nodes, final double[] x, final double[] y, final double h) {
		if (freeLength)
			reduceLength(nodes, x, y, h);
		sumBehind(nodes);
		for (int c = 0; c < 2; c++) {
			vector[c] = pull[c];
			for (int d = c; d < 2; d++)
				matrix[c][d] = blocks[c][d];
		}
		for (int k = 0; k < links; k++) {
			final double kx = y[k] - y[k + 1], ky = x[k + 1] - x[k];
			final int row = 2 * (k + 1);
			vector[k + 2] = kx * pull[row] + ky * pull[row + 1];
			for (int c = 0; c < 2; c++)
				matrix[c][k + 2] = kx * blocks[c][row] + ky * blocks[c][row + 1];
			final double[] rowX = blocks[row], rowY = blocks[row + 1], entries = matrix[k + 2];
			for (int l = k; l < links; l++) {
				final double lx = y[l] - y[l + 1], ly = x[l + 1] - x[l];
				final int column = 2 * (l + 1);
				entries[l + 2] = kx * (rowX[column] * lx + rowX[column + 1] * ly)
					+ ky * (rowY[column] * lx + rowY[column + 1] * ly);
			}
		}
	}

	/** blocks[i][j] = sum over all nodes a >= i, b >= j; for i <= j. */
	private void sumBehind(final NodeSystem nodes) {
		final int size = nodes.size;
		for (int i = size - 2; i >= 0; i -= 2) {
			for (int c = 0; c < 2; c++) {
				final double[] row = blocks[i + c];
				final double[] below = i + 2 < size ? blocks[i + 2 + c] : null;
				double sumX = 0, sumY = 0;
				for (int j = size - 2; j > i; j -= 2) {
					sumX += nodes.get(i + c, j);
					sumY += nodes.get(i + c, j + 1);
					row[j] = sumX + (below == null ? 0 : below[j]);
					row[j + 1] = sumY + (below == null ? 0 : below[j + 1]);
				}
				row[i] = sumX + nodes.get(i + c, i);
				row[i + 1] = sumY + nodes.get(i + c, i + 1);
				pull[i + c] = nodes.vector[i + c] + (below == null ? 0 : pull[i + 2 + c]);
			}
			if (i + 2 < size)
				for (int c = 0; c < 2; c++)
					for (int d = 0; d < 2; d++)
						blocks[i + c][i + d] += blocks[i + d][i + 2 + c];
		}
	}

	/** The last unknown, h: every node moves by (P - P0) / h. */
	private void reduceLength(final NodeSystem nodes, final double[] x, final double[] y,
		final double h) {
		final int size = nodes.size, last = links + 2;
		final double[] d = new double[size];
		for (int i = 0; i <= links; i++) {
			d[2 * i] = (x[i] - x[0]) / h;
			d[2 * i + 1] = (y[i] - y[0]) / h;
		}
		final double[] gd = multiply(nodes, d);
		double hh = 0, right = 0;
		for (int i = 0; i < size; i++) {
			hh += d[i] * gd[i];
			right += d[i] * nodes.vector[i];
		}
		matrix[last][last] = hh;
		vector[last] = right;
		double behindX = 0, behindY = 0;
		for (int k = links; k >= 0; k--) {
			if (k < links)
				matrix[k + 2][last] = (y[k] - y[k + 1]) * behindX + (x[k + 1] - x[k]) * behindY;
			behindX += gd[2 * k];
			behindY += gd[2 * k + 1];
		}
		matrix[0][last] = behindX;
		matrix[1][last] = behindY;
	}

	/**
	 * The symmetric node matrix, of which the upper block triangle is stored,
	 * times d.
	 */
	private static double[] multiply(final NodeSystem nodes, final double[] d) {
		final int size = nodes.size;
		final double[] product = new double[size];
		for (int i = 0; i < size; i++) {
			final int own = i & ~1;
			product[i] += nodes.get(i, own) * d[own] + nodes.get(i, own + 1) * d[own + 1];
			for (int j = own + 2; j < size; j++) {
				product[i] += nodes.get(i, j) * d[j];
				product[j] += nodes.get(i, j) * d[i];
			}
		}
		return product;
	}

	@Override
	public void addStart(final double weight, final double pullX, final double pullY) {
		matrix[0][0] += weight;
		matrix[1][1] += weight;
		vector[0] -= pullX;
		vector[1] -= pullY;
	}

	@Override
	public void addAngle(final int link, final double weight, final double pull) {
		matrix[link + 2][link + 2] += weight;
		vector[link + 2] -= pull;
	}

	@Override
	public void addBend(final int link, final double weight, final double pull) {
		addAngle(link, weight, pull);
		addAngle(link - 1, weight, -pull);
		matrix[link + 1][link + 2] -= weight;
	}

	@Override
	public double[] solve(final double damping) {
		for (int i = 0; i < damped.length; i++) {
			System.arraycopy(matrix[i], i, damped[i], i, damped.length - i);
			damped[i][i] += damping * (damped[i][i] + LEAST_DAMPED);
		}
		return Cholesky.solve(damped, vector);
	}
}
