
package io.github.knotresolver.simulate;

/**
 * Takes away what little a step has stretched the links: nodes move along their
 * links by the least sum of squares that gives every link its length. Newton's
 * method with a tridiagonal matrix, O(n) a round.
 */
final class LengthKeeper {

	/** Largest relative error of a link that is left. */
	private static final double TOLERANCE = 1e-6;

	private static final int ROUNDS = 8;

	private final int held;
	private final double[] tx;
	private final double[] ty;
	private final double[] diagonal;
	private final double[] pull;

	/**
	 * @param links number of links
	 * @param held how many of the first nodes cannot move
	 */
	LengthKeeper(final int links, final int held) {
		this.held = held;
		tx = new double[links];
		ty = new double[links];
		diagonal = new double[links];
		pull = new double[links];
	}

	/** Gives every link its length. */
	void restore(final SimulatedChain chain) {
		for (int round = 0; round < ROUNDS; round++)
			if (measure(chain) < TOLERANCE)
				return;
			else {
				solve();
				move(chain);
			}
	}

	private double measure(final SimulatedChain chain) {
		double worst = 0;
		for (int i = 0; i < tx.length; i++) {
			final double d = chain.distance(i);
			tx[i] = (chain.x[i + 1] - chain.x[i]) / d;
			ty[i] = (chain.y[i + 1] - chain.y[i]) / d;
			pull[i] = i + 1 < held ? 0 : d - chain.link;
			worst = Math.max(worst, Math.abs(pull[i]) / chain.link);
		}
		return worst;
	}

	/** How freely a node moves: 0 if it is held. */
	private double freedom(final int node) {
		return node < held ? 0 : 1;
	}

	private double coupling(final int i) {
		return -freedom(i) * (tx[i] * tx[i - 1] + ty[i] * ty[i - 1]);
	}

	private void solve() {
		for (int i = 0; i < tx.length; i++) {
			diagonal[i] = Math.max(1e-9, freedom(i) + freedom(i + 1));
			if (i == 0)
				continue;
			final double factor = coupling(i) / diagonal[i - 1];
			diagonal[i] -= factor * coupling(i);
			pull[i] -= factor * pull[i - 1];
		}
		for (int i = tx.length - 1; i >= 0; i--) {
			final double after = i + 1 < tx.length ? coupling(i + 1) * pull[i + 1] : 0;
			pull[i] = (pull[i] - after) / diagonal[i];
		}
	}

	private void move(final SimulatedChain chain) {
		for (int i = 0; i < tx.length; i++) {
			chain.x[i] += freedom(i) * pull[i] * tx[i];
			chain.y[i] += freedom(i) * pull[i] * ty[i];
			chain.x[i + 1] -= freedom(i + 1) * pull[i] * tx[i];
			chain.y[i + 1] -= freedom(i + 1) * pull[i] * ty[i];
		}
	}
}
