
package io.github.knotresolver.measure;

import java.util.Arrays;
import java.util.Optional;

import org.apache.commons.math3.stat.regression.SimpleRegression;

import io.github.knotresolver.geometry.Angles;

/**
 * A bending wave that runs along the filament, from a kymograph: at the
 * dominant frequency f of the whole kymograph a sine is fitted at every place
 * s, and the slope of its phase gives the wave speed, 2π f / (dφ/ds). Places
 * near the base that hardly move have no phase and are left out; the others
 * weigh by their amplitude. This is the Fourier analysis that is usual for
 * flagella (Riedel-Kruse, Hilfinger, Howard and Jülicher 2007, How molecular
 * motors shape the flagellar beat, HFSP Journal 1).
 *
 * @param frequency in 1/unit of time
 * @param speed in unit of length/unit of time; positive runs from the fixed end
 *          to the tip
 * @param speedError its standard error
 * @param wavelength speed / frequency, above 0, in the unit of length
 * @param amplitude of the field at the place where it is largest
 * @param place arc length of that place, in the unit of length
 * @param coherence 0..1: the part of the field's variance in time that the sine
 *          explains
 */
public record TravellingWave(double frequency, double speed, double speedError, double wavelength,
	double amplitude, double place, double coherence) {

	/**
	 * @param field tangent angle or curvature
	 * @return its wave; empty if too few frames or places move
	 */
	public static Optional<TravellingWave> of(final Kymograph field) {
		final Optional<Double> frequency = new FieldSpectrum(field, MeasureTuning.LEAST_FRAMES)
			.peak();
		return frequency.flatMap(f -> at(field, f));
	}

	private static Optional<TravellingWave> at(final Kymograph field, final double frequency) {
		final PhaseProfile profile = PhaseProfile.of(field, frequency, MeasureTuning.LEAST_FRAMES);
		final SimpleRegression line = new SimpleRegression();
		for (int i = 0; i < profile.size(); i++)
			if (profile.amplitude(i) >= MeasureTuning.LEAST_AMPLITUDE * profile.largest())
				line.addData(profile.place(i), profile.phase(i));
		if (line.getN() < MeasureTuning.FEWEST_PLACES || line.getSlope() == 0)
			return Optional.empty();
		final double speed = 2 * Math.PI * frequency / line.getSlope();
		final double relative = Math.hypot(
			line.getSlopeStdErr() / line.getSlope() * profile.correlation(),
			profile.frequencyError() / frequency);
		return Optional.of(new TravellingWave(frequency, speed, Math.abs(speed) * relative,
			Math.abs(speed) / frequency, profile.largest(), profile.placeOfLargest(),
			profile.coherence()));
	}

	/** Amplitude and phase of one frequency along the filament. */
	private static final class PhaseProfile {

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

	/** Power of a kymograph's oscillation in time, summed along the filament. */
	private static final class FieldSpectrum {

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
}
