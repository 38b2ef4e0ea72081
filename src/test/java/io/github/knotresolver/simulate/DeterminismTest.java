package io.github.knotresolver.simulate;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.Arrays;
import java.util.List;
import java.util.stream.DoubleStream;

import org.junit.jupiter.api.Test;

import io.github.knotresolver.CancelledProgress;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.progress.CancelledException;
import io.github.knotresolver.progress.Progress;
import io.github.knotresolver.simulate.FilamentSimulator.Trajectory;

class DeterminismTest {

	/** Bits of the tip of seed 1: any change of the numbers changes them. */
	private static final long EXPECTED_BITS = 9203461979087158598L;

	private static Trajectory run(final long seed) {
		return new FilamentSimulator(
			new SimulationParameters(FilamentProperties.microtubule(5), MotorProperties.dynein(100),
				MediumProperties.WATER, new Schedule(20, 4, 0.005, 1), seed))
			.run(Progress.NONE);
	}

	@Test
	void aSeedGivesTheSameMovie() {
		assertEquals(run(1), run(1));
		assertNotEquals(run(1), run(2));
	}

	@Test
	void theNumbersAreTheSameOnAnyMachine() {
		final Polyline last = run(1).curves().get(3);
		assertEquals(EXPECTED_BITS,
			Double.doubleToLongBits(last.last().x()) ^ Double.doubleToLongBits(last.last().y()));
	}

	@Test
	void noiseIsStandardAndPoissonHasItsMean() {
		final Noise noise = new Noise(1);
		final double[] g = DoubleStream.generate(noise::gaussian).limit(200_000).toArray();
		assertEquals(0, Arrays.stream(g).average().orElseThrow(), 0.01);
		assertEquals(1, Arrays.stream(g).map(v -> v * v).average().orElseThrow(), 0.02);
		assertEquals(0.0455, Arrays.stream(g).filter(v -> Math.abs(v) > 2).count() / 2e5, 0.003);
		for (final double mean : new double[]{0, 0.3, 7, 49, 51, 1000}) {
			final double[] p = DoubleStream.generate(() -> noise.poisson(mean)).limit(50_000)
				.toArray();
			assertEquals(mean, Arrays.stream(p).average().orElseThrow(), 0.02 * mean + 1e-12);
			assertEquals(mean,
				Arrays.stream(p).map(v -> (v - mean) * (v - mean)).average().orElseThrow(),
				0.04 * mean + 1e-12);
		}
	}

	@Test
	void motorsLieAtTheWantedDensityWhateverTheWayThere() {
		final SimulatedChain chain = new SimulatedChain(200, 20);
		final List<Motor> near = new MotorField(50, 3).near(chain, 0.2);
		final double area = 20 * 0.4 + Math.PI * 0.04;
		assertEquals(50 * area, near.size(), 3 * Math.sqrt(50 * area));
		assertEquals(near.size(), new java.util.HashSet<>(near).size());
		final SimulatedChain coarse = new SimulatedChain(20, 20);
		assertEquals(near.size(), new MotorField(50, 3).near(coarse, 0.2).size());
		final MotorField other = new MotorField(50, 3);
		final SimulatedChain elsewhere = new SimulatedChain(10, 1);
		Arrays.fill(elsewhere.y, 30);
		other.near(elsewhere, 0.2);
		final List<Motor> again = other.near(chain, 0.2);
		assertEquals(near.get(5).x, again.get(5).x);
	}

	@Test
	void cancellingStopsAtOnce() {
		final Progress cancelled = new CancelledProgress();
		assertThrows(CancelledException.class,
			() -> new FilamentSimulator(SimulationParameters.published(20, 50, 1)).run(cancelled));
	}
}
