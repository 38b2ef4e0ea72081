package io.github.knotresolver.simulate;

/**
 * The simulated filament: an inextensible chain of links with bending
 * elasticity.
 *
 * @param length contour length in µm, 1 to 200; the published simulations use 5
 *          to 50
 * @param persistenceLength persistence length in µm, 1 to 1e5: bending rigidity
 *          divided by thermal energy
 * @param link length of a link in µm, 0.02 to 1 and at most a quarter of the
 *          length; default 0.1, a tenth of the smallest loops
 * @param clamp how the first end is held; default {@link Clamp#PIVOT}
 */
public record FilamentProperties(double length, double persistenceLength, double link,
	Clamp clamp) {

	/** Persistence length of an endless microtubule, in µm. */
	private static final double ENDLESS = 6300;

	/** Length at which shear between protofilaments halves the stiffness, µm. */
	private static final double SHEAR = 21;

	public FilamentProperties {
		Require.within("length", length, 1, 200, "µm");
		Require.within("persistence_length", persistenceLength, 1, 1e5, "µm");
		Require.within("link", link, 0.02, Math.min(1, length / 4), "µm");
	}

	/**
	 * A microtubule that can pivot about its clamped plus end. Its persistence
	 * length grows with its length, 6300 µm / (1 + (21 µm / length)²): measured by
	 * Pampaloni et al. 2006, PNAS 103:10248, doi:10.1073/pnas.0603931103.
	 *
	 * @param length contour length in µm
	 * @return the filament
	 */
	public static FilamentProperties microtubule(final double length) {
		Require.within("length", length, 1, 200, "µm");
		final double ratio = SHEAR / length;
		return new FilamentProperties(length, ENDLESS / (1 + ratio * ratio), 0.1, Clamp.PIVOT);
	}

	/** @return the number of links, at least 4 */
	public int links() {
		return (int) Math.ceil(length / link - 1e-9);
	}

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
}
