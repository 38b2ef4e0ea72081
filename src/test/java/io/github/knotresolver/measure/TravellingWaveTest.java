
package io.github.knotresolver.measure;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Random;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.model.Calibration;

class TravellingWaveTest {

	private static final Calibration MICRONS = new Calibration(0.1, "µm", 2, "s");

	/** Frequency within 1 %, speed within 3 %, both directions. */
	@ParameterizedTest
	@CsvSource({"0, 1", "0.2, 1", "0.2, -1"})
	void waveHasItsSpeed(final double noise, final int direction) {
		final MovieMeasurements m = wave(100, 0.02, 12, direction, noise);
		final TravellingWave w = TravellingWave.of(m.tangentAngleKymograph()).orElseThrow();
		assertEquals(0.02, w.frequency(), 0.0002);
		assertEquals(direction * 0.24, w.speed(), 0.0072);
		assertEquals(12, w.wavelength(), 0.36);
		assertEquals(0.5, w.amplitude(), 0.06);
		assertTrue(w.coherence() > 0.9, "coherence " + w.coherence());
		final double curvature = TravellingWave.of(m.curvatureKymograph()).orElseThrow().speed();
		assertEquals(direction * 0.24, curvature, noise > 0 ? 0.02 : 0.01);
	}

	@Test
	void intervalHoldsTheTrueSpeed() {
		int covered = 0;
		for (int seed = 0; seed < 20; seed++) {
			final TravellingWave w = TravellingWave
				.of(wave(60, 0.02, 12, 1, 0.2, seed).tangentAngleKymograph()).orElseThrow();
			if (Math.abs(w.speed() - 0.24) < 1.96 * w.speedError())
				covered++;
		}
		assertTrue(covered >= 17, covered + " of 20");
	}

	@Test
	void filamentAtRestHasNoWave() {
		final List<Optional<Polyline>> still = new ArrayList<>();
		for (int i = 0; i < 20; i++)
			still.add(Optional.of(Curves.circle(30, 2, 0, 1)));
		assertTrue(TravellingWave
			.of(MovieMeasurements.of("still", still, MICRONS).curvatureKymograph()).isEmpty());
	}

	@Test
	void fewFramesHaveNoWave() {
		assertTrue(TravellingWave.of(wave(5, 0.02, 12, 1, 0.1).tangentAngleKymograph()).isEmpty());
	}

	private static MovieMeasurements wave(final int frames, final double frequency,
		final double wavelength, final int direction, final double noise) {
		return wave(frames, frequency, wavelength, direction, noise, 7);
	}

	/** ψ(s, t) = 0.5 sin(2π (f t - s / wavelength)), 150 px of 0.1 µm. */
	private static MovieMeasurements wave(final int frames, final double frequency,
		final double wavelength, final int direction, final double noise, final int seed) {
		final Random random = new Random(seed);
		final List<Optional<Polyline>> contours = new ArrayList<>();
		for (int t = 0; t < frames; t++) {
			final double[] x = new double[151], y = new double[151];
			for (int i = 1; i <= 150; i++) {
				final double psi = 0.5 * Math.sin(
					2 * Math.PI * (frequency * 2 * t - direction * (i - 0.5) * 0.1 / wavelength));
				x[i] = x[i - 1] + Math.cos(psi);
				y[i] = y[i - 1] + Math.sin(psi);
			}
			contours.add(t % 9 == 4
				? Optional.empty()
				: Optional.of(Curves.noisy(Polyline.of(x, y), noise, random)));
		}
		return MovieMeasurements.of("wave", contours, MICRONS);
	}
}
