
package io.github.knotresolver.simulate;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.ArrayList;
import java.util.List;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.progress.Progress;
import io.github.knotresolver.simulate.FilamentProperties.Clamp;
import io.github.knotresolver.simulate.FilamentSimulator.Trajectory;

/** The simulated filament obeys the physics that it claims. */
class FilamentPhysicsTest {

	private static final MotorProperties NO_MOTORS = MotorProperties.dynein(0);
	private static final MediumProperties COLD = new MediumProperties(1, 0.001, 0.05);

	private static SimulationParameters passive(final FilamentProperties f,
		final MediumProperties medium, final Schedule schedule) {
		return new SimulationParameters(f, NO_MOTORS, medium, schedule, 7);
	}

	private static double angle(final Polyline c, final int link) {
		return Math.atan2(c.y(link + 1) - c.y(link), c.x(link + 1) - c.x(link));
	}

	private static double turned(final Polyline c, final int from, final int to) {
		double sum = 0;
		for (int i = from; i < to; i++)
			sum += Math.IEEEremainder(angle(c, i + 1) - angle(c, i), 2 * Math.PI);
		return sum;
	}

	@ParameterizedTest
	@ValueSource(doubles = {0.005, 0.02})
	void thermalFluctuationsGiveBackThePersistenceLength(final double dt) {
		final double lp = 200;
		final Trajectory t = new FilamentSimulator(
			passive(new FilamentProperties(6, lp, 0.1, Clamp.FREE), MediumProperties.WATER,
				new Schedule(200, 2000, dt, 1)))
			.run(Progress.NONE);
		for (final int lag : new int[]{2, 10, 20}) {
			double squares = 0;
			int count = 0;
			for (final Polyline c : t.curves())
				for (int i = 0; i + lag < c.size() - 1; i++, count++)
					squares += Math.pow(turned(c, i, i + lag), 2);
			// In two dimensions the squared turn grows as arc length over lp.
			assertEquals(lp, lag * 0.1 * count / squares, 0.1 * lp,
				"over " + lag + " links at a time step of " + dt + " s");
		}
	}

	@Test
	void aFreeFilamentDiffusesAsItsDragSays() {
		final FilamentProperties f = new FilamentProperties(2, 1000, 0.2, Clamp.FREE);
		final Schedule s = new Schedule(1000, 10_000, 0.05, 0);
		final Trajectory t = new FilamentSimulator(passive(f, MediumProperties.WATER, s))
			.run(Progress.NONE);
		double squares = 0;
		for (int i = 1; i < t.curves().size(); i++)
			squares += Math.pow(centre(t.curves().get(i)).distanceTo(centre(t.curves().get(i - 1))),
				2);
		final double measured = squares / (4 * 0.1 * (t.curves().size() - 1));
		final double expected = MediumProperties.WATER.thermalEnergy()
			/ (MediumProperties.WATER.dragPerLength() * 2);
		assertEquals(expected, measured, 0.05 * expected);
	}

	/** The centre of drag: end nodes stand for half a link. */
	private static Point centre(final Polyline c) {
		double x = 0, y = 0;
		for (int i = 0; i < c.size() - 1; i++) {
			x += (c.x(i) + c.x(i + 1)) / 2;
			y += (c.y(i) + c.y(i + 1)) / 2;
		}
		return new Point(x / (c.size() - 1), y / (c.size() - 1));
	}

	@Test
	void aClampedPassiveFilamentRelaxesAsACantileverDoes() {
		final double length = 5;
		final FilamentProperties f = new FilamentProperties(length, 1e5, 0.1, Clamp.DIRECTION);
		final double wave = 1.8751040687 / length;
		final double rigidity = passive(f, COLD, Schedule.PUBLISHED).rigidity();
		final double relaxation = COLD.dragPerLength() / (rigidity * Math.pow(wave, 4));
		double early = 0, late = 0, end = 0;
		final int seeds = 40;
		for (int seed = 0; seed < seeds; seed++) {
			final FilamentSimulator s = new FilamentSimulator(
				new SimulationParameters(f, NO_MOTORS, COLD, new Schedule(10, 2, 0.001, 0), seed));
			bend(s.chain(), 0.08);
			advance(s, relaxation);
			early += s.curve().last().y() / seeds;
			advance(s, relaxation);
			late += s.curve().last().y() / seeds;
			advance(s, 8 * relaxation);
			end += s.curve().last().y() / seeds;
		}
		assertEquals(Math.E, early / late, 0.1 * Math.E, "fading in one relaxation time");
		assertEquals(0, end, 0.05 * early, "tip at the end, in µm");
	}

	private static void advance(final FilamentSimulator s, final double time) {
		for (int i = 0; i < Math.round(time / 0.001); i++)
			s.step();
	}

	/** Bends a chain to constant curvature (1/µm), its first link stays. */
	private static void bend(final SimulatedChain c, final double curvature) {
		for (int i = 1; i < c.nodes(); i++) {
			final double heading = curvature * (i - 1) * c.link;
			c.x[i] = c.x[i - 1] + c.link * Math.cos(heading);
			c.y[i] = c.y[i - 1] + c.link * Math.sin(heading);
		}
	}

	@Test
	void theClampCarriesWhatTheMotorsPush() {
		final SimulationParameters p = passive(new FilamentProperties(2, 1e5, 0.1, Clamp.PIVOT),
			COLD, new Schedule(10, 2, 0.005, 0));
		final SimulatedChain chain = new SimulatedChain(20, 2);
		final FilamentMechanics mechanics = new FilamentMechanics(p, chain, 0.005);
		final List<Motor> pushing = new ArrayList<>();
		for (final double arc : new double[]{0.55, 1.25}) {
			final Motor m = new Motor(arc - 0.02, 0);
			m.bind(arc);
			pushing.add(m);
		}
		final Noise noise = new Noise(1);
		final double[] mean = new double[20];
		for (int i = 0; i < 2000; i++) {
			mechanics.step(chain, pushing, noise);
			for (int k = 0; k < 20; k++)
				mean[k] += mechanics.tension()[k] / 2000;
		}
		for (int k = 0; k < 20; k++) {
			final double pushed = k < 5 ? -4 : k > 5 && k < 12 ? -2 : k > 12 ? 0 : mean[k];
			assertEquals(pushed, mean[k], 0.05, "pN in link " + k);
		}
	}

	@Test
	void aLateralMotorPullsAFreeFilamentUntilItLetsGoOfItsForce() {
		final SimulationParameters p = passive(new FilamentProperties(2, 1e5, 0.1, Clamp.FREE),
			COLD, new Schedule(10, 2, 0.005, 0));
		final SimulatedChain chain = new SimulatedChain(20, 2);
		final FilamentMechanics mechanics = new FilamentMechanics(p, chain, 1e-5);
		final Motor m = new Motor(1, 0.05);
		m.bind(1);
		mechanics.step(chain, List.of(m), new Noise(3));
		double drag = 0;
		for (int i = 0; i <= 20; i++)
			drag += (i % 20 == 0 ? 0.5 : 1) * COLD.dragPerLength() * 0.1 * chain.y[i] / 1e-5;
		final double force = p.motors().stiffness() * (0.05 - chain.y[10]);
		assertEquals(force, drag, 0.05 * force, "drag balances the motor's pull");
	}

	@Test
	void linksKeepTheirLengthWhileMotorsWind() {
		final Trajectory t = new FilamentSimulator(SimulationParameters.published(5, 100, 4))
			.run(Progress.NONE);
		for (final Polyline c : t.curves()) {
			assertEquals(5, c.length(), 5e-5);
			for (int i = 1; i < c.size(); i++)
				assertEquals(0.1, c.arc(i) - c.arc(i - 1), 1e-5);
			assertEquals(0, c.first().distanceTo(new Point(0, 0)), 0);
		}
	}

	@Test
	void halvingTheTimeStepChangesStatisticsByLessThanFivePercent() {
		final double[] coarse = statistics(0.005), fine = statistics(0.0025);
		for (int i = 0; i < coarse.length; i++)
			assertEquals(1, fine[i] / coarse[i], 0.05,
				"statistic " + i + ": " + coarse[i] + " and " + fine[i]);
	}

	/** Mean tip speed, curvature (rms) and number of bound motors. */
	private static double[] statistics(final double dt) {
		final double[] sums = new double[3];
		final int seeds = 16, frames = 12;
		for (int seed = 0; seed < seeds; seed++) {
			final SimulationParameters p = new SimulationParameters(
				FilamentProperties.microtubule(5), MotorProperties.dynein(200),
				MediumProperties.WATER, new Schedule(30, frames, dt, 0), seed);
			final FilamentSimulator s = new FilamentSimulator(p);
			Polyline last = s.curve();
			for (int f = 1; f < frames; f++) {
				for (int i = 0; i < p.schedule().stepsPerFrame(); i++)
					s.step();
				final Polyline now = s.curve();
				sums[0] += now.last().distanceTo(last.last());
				for (int i = 0; i < now.size() - 2; i++)
					sums[1] += Math.pow(turned(now, i, i + 1), 2);
				sums[2] += s.boundMotors();
				last = now;
			}
		}
		sums[1] = Math.sqrt(sums[1]);
		return sums;
	}
}
