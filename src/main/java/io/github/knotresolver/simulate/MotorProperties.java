package io.github.knotresolver.simulate;

/**
 * Motors fixed to the surface at random places. A motor binds to the filament
 * within its reach, walks towards the free end (the minus end of a microtubule,
 * for dynein), pulls through a Hookean linker and lets go under load. Defaults
 * are those of yeast cytoplasmic dynein.
 *
 * @param density motors per µm², 0 to 1000; default 50, the published
 *          simulations use 12, 25, 50 and 100
 * @param bindingRate rate of binding within reach, per s; default 5 (Leduc et
 *          al. 2004, doi:10.1073/pnas.0406598101, 4.7 for kinesin)
 * @param bindingRange reach of a free motor in µm; default 0.02
 * @param unbindingRate rate of letting go without load, per s; default 0.04:
 *          run length 1.9 µm at 0.085 µm/s (Reck-Peterson et al. 2006,
 *          doi:10.1016/j.cell.2006.05.046)
 * @param unbindingForce force in pN that speeds up letting go e-fold (Bell
 *          1978, doi:10.1126/science.347575); default 3 (dynein in Müller et
 *          al. 2008, doi:10.1073/pnas.0706825105)
 * @param stallForce force in pN at which a motor stops; linear force-velocity
 *          relation; default 6: gives the winding of the published curves
 *          (docs/simulation.md); 7 was measured on single motors (Gennerich et
 *          al. 2007, doi:10.1016/j.cell.2007.10.016)
 * @param speed speed without load in µm/s; default 0.1 (Reck-Peterson et al.
 *          2006)
 * @param stiffness stiffness of the linker in pN/µm; default 100
 */
public record MotorProperties(double density, double bindingRate, double bindingRange,
	double unbindingRate, double unbindingForce, double stallForce, double speed,
	double stiffness) {

	public MotorProperties {
		Require.within("density", density, 0, 1000, "motors per µm²");
		Require.within("binding_rate", bindingRate, 0, 1000, "per s");
		Require.within("binding_range", bindingRange, 0.001, 0.2, "µm");
		Require.within("unbinding_rate", unbindingRate, 0, 1000, "per s");
		Require.within("unbinding_force", unbindingForce, 0.1, 1000, "pN");
		Require.within("stall_force", stallForce, 0.1, 1000, "pN");
		Require.within("motor_speed", speed, 0, 10, "µm/s");
		Require.within("motor_stiffness", stiffness, 1, 1e4, "pN/µm");
	}

	/**
	 * Yeast dynein.
	 *
	 * @param density motors per µm²
	 * @return the motors
	 */
	public static MotorProperties dynein(final double density) {
		return new MotorProperties(density, 5, 0.02, 0.04, 3, 6, 0.1, 100);
	}

	/**
	 * Speed of a bound motor under load.
	 *
	 * @param assisting force along the walking direction in pN, negative if it
	 *          hinders
	 * @return speed towards the free end in µm/s, 0 to twice the unloaded speed
	 */
	double speedUnder(final double assisting) {
		return speed * Math.max(0, Math.min(2, 1 + assisting / stallForce));
	}

	/**
	 * Rate of letting go under load.
	 *
	 * @param force magnitude of the force in pN
	 * @return the rate per s
	 */
	double unbindingRateUnder(final double force) {
		return unbindingRate * StrictMath.exp(Math.min(100, force / unbindingForce));
	}
}
