package io.github.knotresolver.simulate;

/**
 * Everything that decides a simulated trajectory.
 *
 * @param filament the filament
 * @param motors the motors under it
 * @param medium the fluid around it
 * @param schedule times
 * @param seed start of the random numbers: the same seed gives the same
 *          trajectory on any machine
 */
public record SimulationParameters(FilamentProperties filament, MotorProperties motors,
	MediumProperties medium, Schedule schedule, long seed) {

	/**
	 * A microtubule over dynein as in the published simulations.
	 *
	 * @param length contour length in µm
	 * @param density motors per µm²
	 * @param seed start of the random numbers
	 * @return the parameters
	 */
	public static SimulationParameters published(final double length, final double density,
		final long seed) {
		return new SimulationParameters(FilamentProperties.microtubule(length),
			MotorProperties.dynein(density), MediumProperties.WATER, Schedule.PUBLISHED, seed);
	}

	/** @return the bending rigidity in pN·µm² */
	public double rigidity() {
		return filament.persistenceLength() * medium.thermalEnergy();
	}
}
