
package io.github.knotresolver.measure;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class SpectrumTest {

	@Test
	void sineHasItsFrequencyAmplitudeAndPhase() {
		final double[] v = sine(120, 2.5, 0.037, 1.5, 0.7, 0, new Random(1));
		final DominantFrequency d = DominantFrequency.of(v, 2.5).orElseThrow();
		assertEquals(0.037, d.frequency(), 1e-5);
		assertEquals(1.5, d.amplitude(), 0.01);
		assertEquals(0.7, d.phase(), 0.02);
		assertTrue(d.isSignificant());
	}

	@Test
	void missingFramesAreMissingNotZero() {
		final double[] v = sine(100, 1, 0.08, 1, 0, 0, new Random(2));
		for (int i = 0; i < v.length; i++)
			v[i] = i % 3 == 0 || (i > 40 && i < 55) ? Double.NaN : v[i] + 1000;
		final DominantFrequency d = DominantFrequency.of(v, 1).orElseThrow();
		assertEquals(0.08, d.frequency(), 1e-4);
		assertEquals(1, d.amplitude(), 0.02);
	}

	@Test
	void trendIsNotAnOscillation() {
		final double[] v = sine(100, 1, 0.11, 0.5, 0, 0, new Random(3));
		for (int i = 0; i < v.length; i++)
			v[i] += 0.3 * i;
		assertEquals(0.11, DominantFrequency.of(v, 1).orElseThrow().frequency(), 2e-3);
	}

	@Test
	void spectrumReachesFromOneCycleToHalfTheFrameRate() {
		final Spectrum s = Spectrum.of(sine(50, 2, 0.1, 1, 0, 0.1, new Random(4)), 2);
		assertEquals(0.01, s.frequency()[0], 1e-12);
		assertEquals(0.25, s.frequency()[s.size() - 1], 1e-12);
	}

	/** Sums over all values, one frequency after the other, missing frames left out. */
	@Test
	void amplitudesAreThoseOfLeastSquaresAtEachFrequency() {
		final Random random = new Random(5);
		for (int trial = 0; trial < 20; trial++) {
			final double[] v = sine(9 + random.nextInt(60), 0.5, 0.2, 1, 0, 1, random);
			for (int i = random.nextInt(3); i < v.length - 8; i += 3 + random.nextInt(4))
				v[i] = Double.NaN;
			final TimeSeries series = TimeSeries.of(v, 0.5);
			final FrequencyGrid grid = FrequencyGrid.over(series.frames(), 4, 0.5);
			final double[] found = SineFits.plain(series, grid).amplitudes(series);
			for (int k = 0; k < grid.size(); k++)
				assertEquals(new SineFit(series, grid.frequency(k)).amplitude(), found[k],
					1e-9 * (1 + found[k]), "trial " + trial + ", frequency " + k);
		}
	}

	/** Tables of cosine and sine for each frame and frequency would need 170 GB. */
	@Test
	void longMoviesNeedLittleMemory() {
		final double[] v = sine(70_001, 0.1, 1.23, 2, 0.4, 0.5, new Random(6));
		final Spectrum s = Spectrum.of(v, 0.1);
		int peak = 0;
		for (int k = 1; k < s.size(); k++)
			if (s.amplitude()[k] > s.amplitude()[peak])
				peak = k;
		assertEquals(1.23, s.frequency()[peak], 1e-4);
		assertEquals(2, s.amplitude()[peak], 0.05);
	}

	@Test
	void tooFewOrConstantValuesHaveNoFrequency() {
		assertTrue(
			DominantFrequency.of(new double[]{1, 2, 1, 2, Double.NaN, 1, 2, 1}, 1).isEmpty());
		assertTrue(DominantFrequency.of(new double[50], 1).isEmpty());
		assertTrue(DominantFrequency.of(new double[0], 1).isEmpty());
	}

	/** 95 % intervals of the frequency hold it in 90 to 98 % of cases. */
	@ParameterizedTest
	@ValueSource(doubles = {0.2, 0.6})
	void intervalsCoverTheTrueFrequency(final double noise) {
		int covered = 0;
		final int repeats = 300;
		for (int seed = 0; seed < repeats; seed++) {
			final double[] v = sine(120, 2.5, 0.0371, 1, seed, noise, new Random(seed));
			for (int i = seed % 7; i < v.length; i += 7)
				v[i] = Double.NaN;
			final DominantFrequency d = DominantFrequency.of(v, 2.5).orElseThrow();
			if (Math.abs(d.frequency() - 0.0371) < 1.96 * d.standardError())
				covered++;
		}
		assertTrue(covered >= 0.90 * repeats && covered <= 0.98 * repeats,
			covered + " of " + repeats);
	}

	/** Noise, with or without memory, hardly ever passes for an oscillation. */
	@ParameterizedTest
	@ValueSource(doubles = {0, 0.5, 0.9})
	void noiseRarelyPassesForAnOscillation(final double memory) {
		int alarms = 0;
		final int repeats = 200;
		for (int seed = 0; seed < repeats; seed++) {
			final Random random = new Random(1000 + seed);
			final double[] v = new double[100];
			for (int i = 1; i < v.length; i++)
				v[i] = memory * v[i - 1] + random.nextGaussian();
			if (DominantFrequency.of(v, 1).orElseThrow().isSignificant())
				alarms++;
		}
		assertTrue(alarms <= 0.09 * repeats, alarms + " of " + repeats);
	}

	@Test
	void oscillationInNoiseIsFound() {
		int found = 0;
		for (int seed = 0; seed < 30; seed++)
			if (DominantFrequency.of(sine(100, 1, 0.07, 1, seed, 0.7, new Random(seed)), 1)
				.orElseThrow().isSignificant())
				found++;
		assertTrue(found >= 28, found + " of 30");
	}

	@Test
	void oneSlowBendIsNotAnOscillation() {
		final double[] v = new double[40];
		for (int i = 0; i < v.length; i++)
			v[i] = Math.cos(2 * Math.PI * i / 40);
		assertFalse(DominantFrequency.of(v, 1).orElseThrow().isSignificant());
	}

	private static double[] sine(final int n, final double interval, final double frequency,
		final double amplitude, final double phase, final double noise, final Random random) {
		final double[] v = new double[n];
		for (int i = 0; i < n; i++)
			v[i] = amplitude * Math.cos(2 * Math.PI * frequency * i * interval - phase)
				+ noise * random.nextGaussian();
		return v;
	}
}
