package io.github.knotresolver.simulate;

import io.github.knotresolver.model.UserException;

/**
 * How long, how often and how finely.
 *
 * @param duration simulated time in s, above 0 and at most 1e5; default 300
 * @param frames pictures, 2 to 10,000, the first at the end of the warm-up;
 *          default 120
 * @param timeStep step of the integration in s, 1e-5 to 0.1; default 0.005
 * @param warmUp time before the first picture in s, 0 to 1e5; default 0
 */
public record Schedule(double duration, int frames, double timeStep, double warmUp) {

	/** Five minutes in 120 frames, as published. */
	public static final Schedule PUBLISHED = new Schedule(300, 120, 0.005, 0);

	/** Days of work. */
	private static final double MOST_STEPS = 1e9;

	public Schedule {
		Require.within("duration", duration, 0.001, 1e5, "s");
		Require.within("frames", frames, 2, 10_000);
		Require.within("time_step", timeStep, 1e-5, 0.1, "s");
		Require.within("warm_up", warmUp, 0, 1e5, "s");
		if ((duration + warmUp) / timeStep > MOST_STEPS)
			throw new UserException("time_step " + timeStep + " s makes more than "
				+ (long) MOST_STEPS + " steps of " + (duration + warmUp)
				+ " s; choose a longer one, or a shorter duration and warm_up.");
	}

	/** @return time between frames in s: duration / frames */
	public double frameInterval() {
		return duration / frames;
	}

	/** @return steps between two frames, at least 1 */
	int stepsPerFrame() {
		return (int) Math.max(1, Math.ceil(frameInterval() / timeStep - 1e-9));
	}

	/** @return steps before the first picture */
	long warmUpSteps() {
		return (long) Math.ceil(warmUp / step() - 1e-9);
	}

	/** @return the step really taken in s: a whole number of them a frame */
	double step() {
		return frameInterval() / stepsPerFrame();
	}
}
