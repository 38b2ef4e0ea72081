
package io.github.knotresolver.measure;

import java.util.Arrays;

import io.github.knotresolver.geometry.Angles;

/** Amplitude and phase of one frequency along the filament. */
final class PhaseProfile {

	private final double[] place;
	private final double[] amplitude;
	private final double[] phase;
	private final double explained;
	private final double frequencyError;

	private PhaseProfile(final double[] place, final double[] amplitude, final double[] phase,
		final double explained, final double frequencyError) {
		this.place = place;
		this.amplitude = amplitude;
		this.phase = phase;
		this.explained = explained;
		this.frequencyError = frequencyError;
	}

	/** Fits a sine at each place that enough frames reach. */
	static PhaseProfile of(final Kymograph field, final double frequency,
		final double leastFrames) {
		final int n = field.columns();
		final double[] place = new double[n], amplitude = new double[n], phase = new double[n];
		double total = 0, rest = 0;
		int k = 0;
		for (int j = 0; j < n; j++) {
			final double[] values = field.series(j);
			if (!FieldSpectrum.isReached(values, leastFrames))
				continue;
			final TimeSeries series = TimeSeries.of(values, field.interval()).detrended();
			final SineFit sine = new SineFit(series, frequency);
			place[k] = j * field.step();
			amplitude[k] = sine.amplitude();
			final double angle = sine.phase();
			phase[k] = k == 0 ? angle : Angles.nearest(angle, phase[k - 1]);
			total += series.variance();
			rest += sine.residual().variance();
			k++;
		}
		final double explained = total > 0 ? 1 - rest / total : 0;
		final double duration = field.frames() * field.interval();
		final double error = Math
			.sqrt(3.0 / field.frames() * Math.max(0, 1 - explained) / Math.max(1e-9, explained))
			/ (Math.PI * duration);
		return new PhaseProfile(Arrays.copyOf(place, k), Arrays.copyOf(amplitude, k),
			Arrays.copyOf(phase, k), explained, error);
	}

	int size() {
		return place.length;
	}

	double place(final int i) {
		return place[i];
	}

	double amplitude(final int i) {
		return amplitude[i];
	}

	double phase(final int i) {
		return phase[i];
	}

	double largest() {
		return Arrays.stream(amplitude).max().orElse(0);
	}

	double placeOfLargest() {
		int best = 0;
		for (int i = 1; i < amplitude.length; i++)
			if (amplitude[i] > amplitude[best])
				best = i;
		return place.length == 0 ? Double.NaN : place[best];
	}

	double coherence() {
		return explained;
	}

	double frequencyError() {
		return frequencyError;
	}

	/** By how much errors of the slope grow because errors of neighbours are correlated. */
	double correlation() {
		return Math.sqrt(Math.min(MeasureTuning.REPEATED, Math.max(1, place.length / 4.0)));
	}
}
