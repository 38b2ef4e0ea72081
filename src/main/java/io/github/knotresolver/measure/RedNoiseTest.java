
package io.github.knotresolver.measure;

import java.util.Arrays;
import java.util.Random;

import io.github.knotresolver.progress.Cancellation;
import io.github.knotresolver.progress.Workers;

/**
 * Does a peak stand out of noise with memory? The null hypothesis is a
 * first-order autoregressive process with the series' own variance and
 * correlation of neighbouring frames (an oscillation in the series only makes
 * that more cautious), as in Schulz and Mudelsee (2002,
 * doi:10.1016/S0098-3004(01)00044-9). The statistic is the power of the highest
 * peak over the process's own spectrum at that frequency; each simulated series
 * goes through all the same steps.
 */
final class RedNoiseTest {

	private static final long SEED = 20240229;

	private final TimeSeries series;
	private final SineFits fits;

	/** @param series a series without trend */
	RedNoiseTest(final TimeSeries series) {
		this.series = series;
		this.fits = SineFits.tapered(series, FrequencyGrid.over(series.frames(),
			MeasureTuning.NOISE_OVERSAMPLING, series.interval()));
	}

	/** @return the part of simulations that stand out as much, never quite 0 */
	double falseAlarmProbability() {
		final double observed = prominence(series);
		final double rho = series.correlation();
		final Random random = new Random(SEED);
		final TimeSeries[] noise = new TimeSeries[MeasureTuning.SIMULATIONS];
		Arrays.setAll(noise, i -> simulated(rho, random));
		final long asHigh = Workers.present()
			.map(MeasureTuning.SIMULATIONS, i -> prominence(noise[i].detrended()) >= observed)
			.stream().filter(higher -> higher).count();
		return (asHigh + 1) / (MeasureTuning.SIMULATIONS + 1.0);
	}

	/** Power of the highest peak over the noise's power there. */
	private double prominence(final TimeSeries s) {
		final double rho = s.correlation();
		final double[] amplitudes = fits.amplitudes(s);
		int peak = 0;
		for (int k = 1; k < amplitudes.length; k++)
			if (amplitudes[k] > amplitudes[peak])
				peak = k;
		final double turn = 2 * Math.PI * fits.grid().frequency(peak) * s.interval();
		final double noise = s.variance() * (1 - rho * rho)
			/ (1 - 2 * rho * Math.cos(turn) + rho * rho);
		return amplitudes[peak] * amplitudes[peak] / noise;
	}

	private TimeSeries simulated(final double rho, final Random random) {
		Cancellation.check();
		final double[] values = new double[series.size()];
		final double kick = Math.sqrt(1 - rho * rho);
		double state = random.nextGaussian();
		int frame = 1;
		for (int i = 0; i < values.length; i++) {
			final int at = series.frame(i) - series.frame(0);
			for (; frame <= at; frame++)
				state = rho * state + kick * random.nextGaussian();
			values[i] = state;
		}
		return series.with(values);
	}
}
