package io.github.knotresolver.fit;

/**
 * The system for pixels that couple only neighbouring nodes, solved in O(n) by dynamic
 * programming along the chain (the Riccati recursion of linear-quadratic control, R. E.
 * Kalman, Bol. Soc. Mat. Mex. 5 (1960) 102-119): the state before link k is how far node k
 * has moved and how far link k-1 has turned, the control is how far link k turns. From the
 * tip to the fixed end, the cost of all that lies behind is a quadratic form of the state,
 * from which the best turn follows; then the turns are played forwards.
 */
final class ChainSystem implements StepSystem {

	/** Moved x, moved y, turn of the link before, turn of this link. */
	private static final int X = 0, Y = 1, BEFORE = 2, TURN = 3;

	private final int links;

	// Of each node: its block of the node matrix (xx, xy, yy), that to the next node (xx, xy,
	// yx, yy), and how it moves with the link before it.
	private final double[][] own;
	private final double[][] next;
	private final double[][] lever;

	private final double[] start = new double[4];
	private final double[] angle;
	private final double[] bend;
	private final double[] curvature;

	// Gains of the turns: constant part, then by the state.
	private final double[][] gain;

	ChainSystem(final int links) {
		this.links = links;
		own = new double[links + 1][3];
		next = new double[links][4];
		lever = new double[links][2];
		angle = new double[2 * links];
		bend = new double[links];
		curvature = new double[links];
		gain = new double[links][4];
	}

	@Override
	public void reduce(final NodeSystem nodes, final double[] x, final double[] y, final double h) {
		// How all nodes from i on answer if they move together.
		double xx = 0, xy = 0, yy = 0, pullX = 0, pullY = 0;
		for (int i = links; i >= 0; i--) {
			final int r = 2 * i;
			own[i][0] = nodes.get(r, r);
			own[i][1] = nodes.get(r, r + 1);
			own[i][2] = nodes.get(r + 1, r + 1);
			xx += own[i][0];
			xy += own[i][1];
			yy += own[i][2];
			if (i < links) {
				for (int c = 0; c < 4; c++)
					next[i][c] = nodes.get(r + c / 2, r + 2 + c % 2);
				xx += 2 * next[i][0];
				xy += next[i][1] + next[i][2];
				yy += 2 * next[i][3];
			}
			pullX += nodes.vector[r];
			pullY += nodes.vector[r + 1];
			if (i > 0)
				setLink(i - 1, y[i - 1] - y[i], x[i] - x[i - 1], xx, xy, yy, pullX, pullY);
		}
		start[0] = xx;
		start[1] = yy;
		start[2] = pullX;
		start[3] = pullY;
		extraX = 0;
		extraY = 0;
	}

	private double extraX;
	private double extraY;

	private void setLink(final int k, final double lx, final double ly, final double xx,
		final double xy, final double yy, final double pullX, final double pullY) {
		lever[k][0] = lx;
		lever[k][1] = ly;
		curvature[k] = lx * lx * xx + 2 * lx * ly * xy + ly * ly * yy;
		angle[2 * k] = 0;
		angle[2 * k + 1] = lx * pullX + ly * pullY;
		bend[k] = 0;
	}

	@Override
	public void addStart(final double weight, final double pullX, final double pullY) {
		extraX += weight;
		extraY += weight;
		start[2] -= pullX;
		start[3] -= pullY;
	}

	@Override
	public void addAngle(final int link, final double weight, final double pull) {
		angle[2 * link] += weight;
		angle[2 * link + 1] -= pull;
	}

	@Override
	public void addBend(final int link, final double weight, final double pull) {
		bend[link] += weight;
		angle[2 * link + 1] -= pull;
		angle[2 * link - 1] += pull;
	}

	@Override
	public double[] solve(final double damping) {
		final double[][] cost = new double[3][3];
		final double[] slope = new double[3];
		cost[X][X] = own[links][0];
		cost[X][Y] = own[links][1];
		cost[Y][X] = own[links][1];
		cost[Y][Y] = own[links][2];
		for (int k = links - 1; k >= 0; k--)
			if (!stepBack(k, damping, cost, slope))
				return null;
		return playForward(cost, slope, damping);
	}

	/** From the cost behind link k to that behind link k - 1; false if it has no minimum. */
	private boolean stepBack(final int k, final double damping, final double[][] cost,
		final double[] slope) {
		final double lx = lever[k][0], ly = lever[k][1];
		final double[][] m = new double[4][4];
		final double[] v = new double[4];
		// The next state is (x + lx turn, y + ly turn, turn).
		for (int a = 0; a < 2; a++) {
			for (int b = 0; b < 2; b++)
				m[a][b] = cost[a][b] + own[k][a + b] + next[k][2 * a + b] + next[k][2 * b + a];
			m[a][TURN] = (cost[a][X] + next[k][2 * a]) * lx + (cost[a][Y] + next[k][2 * a + 1]) * ly
				+ cost[a][BEFORE];
			m[TURN][a] = m[a][TURN];
			v[a] = slope[a];
		}
		final double diagonal = curvature[k] + angle[2 * k] + bend[k]
			+ (k + 1 < links ? bend[k + 1] : 0);
		m[TURN][TURN] = lx * lx * cost[X][X] + 2 * lx * ly * cost[X][Y] + ly * ly * cost[Y][Y]
			+ 2 * (lx * cost[X][BEFORE] + ly * cost[Y][BEFORE]) + cost[BEFORE][BEFORE] + bend[k]
			+ angle[2 * k] + damping * (diagonal + ReducedSystem.LEAST_DAMPED);
		m[BEFORE][BEFORE] = bend[k];
		m[BEFORE][TURN] = -bend[k];
		m[TURN][BEFORE] = -bend[k];
		v[TURN] = lx * slope[X] + ly * slope[Y] + slope[BEFORE] + angle[2 * k + 1];
		if (!(m[TURN][TURN] > 0))
			return false;
		gain[k][TURN] = v[TURN] / m[TURN][TURN];
		for (int a = 0; a < 3; a++)
			gain[k][a] = -m[TURN][a] / m[TURN][TURN];
		for (int a = 0; a < 3; a++) {
			for (int b = 0; b < 3; b++)
				cost[a][b] = m[a][b] + m[a][TURN] * gain[k][b];
			slope[a] = v[a] - m[a][TURN] * gain[k][TURN];
		}
		return true;
	}

	private double[] playForward(final double[][] cost, final double[] slope,
		final double damping) {
		final double xx = cost[X][X] + extraX
			+ damping * (start[0] + extraX + ReducedSystem.LEAST_DAMPED);
		final double yy = cost[Y][Y] + extraY
			+ damping * (start[1] + extraY + ReducedSystem.LEAST_DAMPED);
		final double xy = cost[X][Y], determinant = xx * yy - xy * xy;
		if (!(xx > 0 && determinant > 0))
			return null;
		final double px = slope[X] + start[2], py = slope[Y] + start[3];
		final double[] step = new double[links + 2];
		step[0] = (yy * px - xy * py) / determinant;
		step[1] = (xx * py - xy * px) / determinant;
		double x = step[0], y = step[1], before = 0;
		for (int k = 0; k < links; k++) {
			final double turn = gain[k][TURN] + gain[k][X] * x + gain[k][Y] * y
				+ gain[k][BEFORE] * before;
			step[k + 2] = turn;
			x += lever[k][0] * turn;
			y += lever[k][1] * turn;
			before = turn;
		}
		return step;
	}
}
