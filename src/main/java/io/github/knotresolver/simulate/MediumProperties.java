package io.github.knotresolver.simulate;

/**
 * The fluid around the filament.
 *
 * @param temperature in kelvin, 1 to 400; default 310 (37 °C, as in the
 *          published assay)
 * @param viscosity in Pa·s (the same as pN·s/µm²), 1e-4 to 100; default 0.001
 * @param axisHeight distance of the filament's axis from the surface in µm,
 *          0.0126 to 10; default 0.05, the length of a motor
 */
public record MediumProperties(double temperature, double viscosity, double axisHeight) {

	/** Radius of a microtubule in µm. */
	static final double RADIUS = 0.0125;

	/** Boltzmann's constant in pN·µm/K. */
	private static final double BOLTZMANN = 1.380649e-5;

	/** Water at 37 °C, the filament a motor's length above the glass. */
	public static final MediumProperties WATER = new MediumProperties(310, 0.001, 0.05);

	public MediumProperties {
		Require.within("temperature", temperature, 1, 400, "K");
		Require.within("viscosity", viscosity, 1e-4, 100, "Pa s");
		Require.within("axis_height", axisHeight, 0.0126, 10, "µm");
	}

	/** @return the thermal energy in pN·µm */
	public double thermalEnergy() {
		return BOLTZMANN * temperature;
	}

	/**
	 * Drag on a cylinder near a wall, across its axis and taken for both
	 * directions: 4 π viscosity / acosh(height / radius); Hunt, Gittes, Howard
	 * 1994, doi:10.1016/S0006-3495(94)80537-5.
	 *
	 * @return drag per length in pN·s/µm²
	 */
	public double dragPerLength() {
		final double ratio = axisHeight / RADIUS;
		return 4 * Math.PI * viscosity / StrictMath.log(ratio + Math.sqrt(ratio * ratio - 1));
	}
}
