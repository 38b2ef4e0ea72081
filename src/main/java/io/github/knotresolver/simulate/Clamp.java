
package io.github.knotresolver.simulate;

/** How the first end of the simulated filament is held. */
public enum Clamp {

	/** The end stays in place and is free to turn. */
	PIVOT(1),

	/** The end stays in place and keeps its direction. */
	DIRECTION(2),

	/** Nothing is held: a filament that swims. */
	FREE(0);

	private final int heldNodes;

	Clamp(final int heldNodes) {
		this.heldNodes = heldNodes;
	}

	/** @return how many of the first nodes cannot move */
	int heldNodes() {
		return heldNodes;
	}
}
