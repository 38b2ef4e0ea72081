
package io.github.knotresolver.measure;

import io.github.knotresolver.model.Calibration;

/**
 * What is measured of a contour in one frame: headers, axes and documents take
 * key, name and unit from here.
 */
public enum Quantity {

	/** ∫ |r'(s)| ds of the smoothed contour. */
	LENGTH("length", "Length", Dimension.LENGTH),
	/** Distance of the ends of the smoothed contour. */
	END_TO_END("end_to_end", "End-to-end distance", Dimension.LENGTH),
	/** Tangent angle at the free tip, unwrapped along contour and time. */
	TIP_ANGLE("tip_angle", "Tip angle", Dimension.ANGLE),
	/** √(1/L ∫ |r - centroid|² ds). */
	RADIUS_OF_GYRATION("radius_of_gyration", "Radius of gyration", Dimension.LENGTH),
	/** ½ B ∫ κ² ds, B the rigidity, or without one for B = 1. */
	BENDING_ENERGY("bending_energy", "Bending energy", Dimension.ENERGY),
	/** (ψ(tip) - ψ(base)) / 2π. */
	TURNING_NUMBER("turning_number", "Turning number", Dimension.NONE),
	/** How often the smoothed contour crosses itself. */
	CROSSINGS("crossings", "Crossings", Dimension.NONE);

	/** What kind of unit a quantity has. */
	public enum Dimension {
		/** The image's unit of length. */
		LENGTH,
		/** Radians. */
		ANGLE,
		/** The unit that the rigidity gives; see {@link Rigidity}. */
		ENERGY,
		/** A number. */
		NONE
	}

	private final String key;
	private final String label;
	private final Dimension dimension;

	Quantity(final String key, final String label, final Dimension dimension) {
		this.key = key;
		this.label = label;
		this.dimension = dimension;
	}

	/** @return the name in file headers and macros: snake_case */
	public String key() {
		return key;
	}

	/** @return the name for people */
	public String label() {
		return label;
	}

	/** @return what kind of unit it has */
	public Dimension dimension() {
		return dimension;
	}

	/**
	 * @param c calibration
	 * @param rigidity rigidity that bending energies are given with
	 * @return the unit; empty for a number
	 */
	public String unit(final Calibration c, final Rigidity rigidity) {
		return switch (dimension) {
			case LENGTH -> c.unit();
			case ANGLE -> "rad";
			case ENERGY -> rigidity.energyUnit(c);
			case NONE -> "";
		};
	}
}
