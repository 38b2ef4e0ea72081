
package io.github.knotresolver.simulate;

import java.util.ArrayList;
import java.util.List;

import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.model.UserException;
import io.github.knotresolver.progress.Progress;

/**
 * Two-dimensional Brownian dynamics of a clamped, inextensible, semiflexible
 * filament over motors. The motors walk towards the free end and so push the
 * filament towards its clamp, where it buckles, beats and winds up.
 * <p>
 * Links keep their length to one part in a million. Strands of the filament do
 * not feel each other, as in the published model. O(frames · steps · links).
 */
public final class FilamentSimulator {

	/** A link whose length is off by this (relative) is not a link any more. */
	private static final double TORN = 0.1;

	private final SimulationParameters parameters;
	private final SimulatedChain chain;
	private final Motors motors;
	private final FilamentMechanics mechanics;
	private final Noise noise;

	/**
	 * A filament that lies straight along x, its first end at the origin, with no
	 * motor bound.
	 *
	 * @param parameters everything that decides the trajectory
	 */
	public FilamentSimulator(final SimulationParameters parameters) {
		this.parameters = parameters;
		final FilamentProperties filament = parameters.filament();
		chain = new SimulatedChain(filament.links(), filament.length());
		motors = new Motors(parameters.motors(), parameters.seed());
		mechanics = new FilamentMechanics(parameters, chain, parameters.schedule().step());
		noise = new Noise(~parameters.seed());
	}

	/**
	 * Simulates the whole schedule.
	 *
	 * @param progress told after every frame; may cancel
	 * @return one curve a frame, the first after the warm-up
	 * @throws UserException if the time step is too long for the filament, so that the solution is
	 *           none
	 */
	public Trajectory run(final Progress progress) {
		final Schedule schedule = parameters.schedule();
		advance(schedule.warmUpSteps(), progress);
		final List<Polyline> curves = new ArrayList<>(schedule.frames());
		curves.add(curve());
		while (curves.size() < schedule.frames()) {
			advance(schedule.stepsPerFrame(), progress);
			curves.add(curve());
			progress.report("Simulating", (double) curves.size() / schedule.frames());
		}
		return new Trajectory(curves, schedule.frameInterval());
	}

	private void advance(final long steps, final Progress progress) {
		for (long i = 0; i < steps; i++) {
			if (i % 64 == 0)
				progress.checkCancelled();
			step();
		}
	}

	/** Moves motors and filament by one step of time. */
	void step() {
		motors.step(chain, parameters.schedule().step(), noise);
		mechanics.step(chain, motors.bound(), noise);
		if (!(chain.worstStrain() < TORN))
			throw new UserException("time_step " + parameters.schedule().timeStep()
				+ " s is too long for this filament: its links do not keep their length any more; "
				+ "choose a shorter one, a longer link, or a longer persistence_length.");
	}

	/** @return the filament as it is now, in µm */
	Polyline curve() {
		return Polyline.of(chain.x, chain.y);
	}

	/** @return everything that decides the trajectory */
	public SimulationParameters parameters() {
		return parameters;
	}

	/** @return the filament itself: a test may bend it */
	SimulatedChain chain() {
		return chain;
	}

	/** @return how many motors hold the filament */
	int boundMotors() {
		return motors.bound().size();
	}

	/** @return the tension of every link in pN, negative where it is pushed */
	double[] tension() {
		return mechanics.tension();
	}

	/**
	 * What a simulation gives.
	 *
	 * @param curves one curve a frame in µm, the clamped end first, at the origin
	 * @param frameInterval time between frames in s
	 */
	public record Trajectory(List<Polyline> curves, double frameInterval) {

		public Trajectory {
			curves = List.copyOf(curves);
		}
	}
}
