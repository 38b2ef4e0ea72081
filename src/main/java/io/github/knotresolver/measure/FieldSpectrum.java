
package io.github.knotresolver.measure;

import java.util.Arrays;
import java.util.Optional;

/** Power of a kymograph's oscillation in time, summed along the filament. */
final class FieldSpectrum {

	private final Kymograph field;
	private final double leastFrames;

	FieldSpectrum(final Kymograph field, final double leastFrames) {
		this.field = field;
		this.leastFrames = leastFrames;
	}

	/** @return whether enough frames reach a place */
	static boolean isReached(final double[] series, final double leastFrames) {
		final long present = Arrays.stream(series).filter(Double::isFinite).count();
		return present >= Math.max(MeasureTuning.FEWEST_FRAMES, leastFrames * series.length);
	}

	/** @return the frequency of the highest power; empty if nothing moves */
	Optional<Double> peak() {
		final double interval = field.interval();
		// One grid for all places, from the duration of the whole movie.
		final FrequencyGrid grid = FrequencyGrid.over(field.frames(),
			MeasureTuning.FIELD_OVERSAMPLING, interval);
		final double[] power = new double[grid.size()];
		for (int j = 0; j < field.columns(); j += Math.max(1,
			field.columns() / MeasureTuning.FIELD_PLACES)) {
			final double[] values = field.series(j);
			if (!isReached(values, leastFrames))
				continue;
			final TimeSeries series = TimeSeries.of(values, interval).detrended();
			final double[] a = SineFits.tapered(series, grid).amplitudes(series);
			for (int k = 0; k < a.length; k++)
				power[k] += a[k] * a[k];
		}
		int best = 0;
		for (int k = 1; k < power.length; k++)
			if (power[k] > power[best])
				best = k;
		return power[best] < 1e-20
			? Optional.empty()
			: Optional.of(grid.frequency(best) + summit(power, best)
				/ (MeasureTuning.FIELD_OVERSAMPLING * field.frames() * interval));
	}

	/** Where a parabola through the peak and its neighbours is highest. */
	private static double summit(final double[] power, final int peak) {
		if (peak == 0 || peak == power.length - 1)
			return 0;
		final double left = power[peak - 1], right = power[peak + 1];
		final double bend = left - 2 * power[peak] + right;
		return bend < 0 ? (left - right) / (2 * bend) : 0;
	}
}
