package io.github.knotresolver.simulate;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

import io.github.knotresolver.model.UserException;
import io.github.knotresolver.progress.Progress;
import io.github.knotresolver.simulate.FilamentProperties.Clamp;

/** A simulation that cannot succeed ends with a sentence. */
class BoundedSimulationTest {

	/** Its nodes flew away, so far that the search for motors near them never ended. */
	@Test
	void aFilamentThatIsTooSoftForTheTimeStepIsRefused() {
		for (final double persistence : new double[]{1, 10})
			assertTrue(assertThrows(UserException.class,
				() -> simulate(persistence, new Schedule(2, 5, 0.005, 0))).getMessage()
				.startsWith("time_step 0.005 s is too long for this filament"));
		simulate(1000, new Schedule(2, 5, 0.005, 0));
	}

	@Test
	void stepsAreNotWithoutNumber() {
		assertEquals(
			"time_step 1.0E-5 s makes more than 1000000000 steps of 100000.0 s; choose a longer one, or a shorter duration and warm_up.",
			assertThrows(UserException.class, () -> new Schedule(1e5, 2, 1e-5, 0)).getMessage());
	}

	private static void simulate(final double persistence, final Schedule schedule) {
		final FilamentProperties filament = new FilamentProperties(20, persistence, 0.1,
			Clamp.PIVOT);
		new FilamentSimulator(new SimulationParameters(filament,
			new MotorProperties(50, 5, 0.02, 0.04, 3, 6, 0.1, 100),
			new MediumProperties(310, 0.001, 0.05), schedule, 1)).run(Progress.NONE);
	}
}
