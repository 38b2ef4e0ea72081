package io.github.knotresolver.evaluate.like;

import io.github.knotresolver.model.UserException;
import io.github.knotresolver.simulate.Clamp;
import io.github.knotresolver.simulate.FilamentProperties;
import io.github.knotresolver.simulate.MediumProperties;
import io.github.knotresolver.simulate.MotorProperties;
import io.github.knotresolver.simulate.Schedule;
import io.github.knotresolver.simulate.SimulationParameters;

/**
 * What to simulate, so that the motion resembles the user's.
 *
 * @param length of the filament in µm
 * @param clamp how its first end is held
 * @param density motors per µm²
 * @param interval simulated time between frames in s. Where it differs from the
 *          user's frame interval, the user's filament moves faster or slower than
 *          the model's default: all rates and speeds are scaled alike, which is
 *          the same as to scale time
 * @param warmUp simulated time before the first frame in s
 */
public record LikeMotion(double length, Clamp clamp, double density, double interval,
	double warmUp) {

	/** Step of the integration in s, and its share of the interval. */
	private static final double LONGEST_STEP = 0.01, SHARE = 0.05, SHORTEST_STEP = 1e-4;

	/**
	 * @param frames number of frames
	 * @param seed start of the random numbers
	 * @return the simulation
	 * @throws UserException if there can be no such simulation, in one
	 *           sentence
	 */
	SimulationParameters simulation(final int frames, final long seed) {
		final FilamentProperties usual = FilamentProperties.microtubule(length);
		final double step = Math.max(SHORTEST_STEP, Math.min(LONGEST_STEP, SHARE * interval));
		return new SimulationParameters(
			new FilamentProperties(length, usual.persistenceLength(), usual.link(), clamp),
			MotorProperties.dynein(density), MediumProperties.WATER,
			new Schedule(frames * interval, frames, step, warmUp), seed);
	}
}
