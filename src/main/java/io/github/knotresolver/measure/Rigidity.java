
package io.github.knotresolver.measure;

import io.github.knotresolver.model.Calibration;
import io.github.knotresolver.model.UserException;

/**
 * What turns the bending of a curve into an energy.
 *
 * @param kind how the rigidity is known
 * @param value the rigidity, above 0
 */
public record Rigidity(Kind kind, double value) {

	/** How the rigidity is known. */
	public enum Kind {
		/** Not known: the energy is per rigidity, in 1/unit of length. */
		UNKNOWN,
		/** As persistence length: the energy is in kT. */
		PERSISTENCE_LENGTH,
		/** As energy × length, in pN µm²: the energy is in pN µm. */
		FLEXURAL
	}

	/** Not known: energies are those of a filament of rigidity 1. */
	public static final Rigidity UNKNOWN = new Rigidity(Kind.UNKNOWN, 1);

	public Rigidity {
		if (!(value > 0) || Double.isInfinite(value))
			throw new UserException(
				(kind == Kind.PERSISTENCE_LENGTH ? "The persistence length" : "The rigidity")
					+ " must be above 0, but is " + value + ".");
	}

	/**
	 * @param length persistence length in the unit of length, above 0 (for
	 *          microtubules some millimetres)
	 * @return the rigidity: energies are in kT
	 */
	public static Rigidity ofPersistenceLength(final double length) {
		return new Rigidity(Kind.PERSISTENCE_LENGTH, length);
	}

	/**
	 * @param rigidity flexural rigidity EI in pN µm², above 0 (for microtubules
	 *          some 20)
	 * @return the rigidity: energies are in pN µm; only for images in µm
	 */
	public static Rigidity ofFlexural(final double rigidity) {
		return new Rigidity(Kind.FLEXURAL, rigidity);
	}

	/**
	 * @param c calibration
	 * @return the unit of bending energies
	 * @throws UserException if the rigidity's unit of length is not
	 *           that of the image
	 */
	public String energyUnit(final Calibration c) {
		if (kind == Kind.FLEXURAL && !c.unit().equals("µm"))
			throw new UserException(
				"A rigidity in pN µm² needs an image calibrated in µm, but its unit is " + c.unit()
					+ "; calibrate it or give a persistence length.");
		return switch (kind) {
			case UNKNOWN -> "1/" + c.unit();
			case PERSISTENCE_LENGTH -> "kT";
			case FLEXURAL -> "pN µm";
		};
	}
}
