package io.github.knotresolver.fit;

/**
 * The linear system of one step of the fit, in the chain's own unknowns: x0, y0, θ1..θn
 * and, if wanted, the link length. Every node behind a link moves with its direction:
 * dPᵢ/dθₖ = h (-sin θₖ, cos θₖ) for all nodes i behind link k.
 */
interface StepSystem {

	/**
	 * Sets the system to that of the image term.
	 *
	 * @param nodes the normal equations of the nodes
	 * @param x columns of the nodes
	 * @param y rows of the nodes
	 * @param h length of a link
	 */
	void reduce(NodeSystem nodes, double[] x, double[] y, double h);

	/** Adds a square price of the start's place. */
	void addStart(double weight, double pullX, double pullY);

	/** Adds a square price of a link's direction. */
	void addAngle(int link, double weight, double pull);

	/** Adds a square price of the difference of a link's direction to the one before. */
	void addBend(int link, double weight, double pull);

	/**
	 * Solves the system with its diagonal made larger by a relative amount.
	 *
	 * @param damping the amount, above 0
	 * @return the step in all unknowns; null if the system is singular even so
	 */
	double[] solve(double damping);
}
