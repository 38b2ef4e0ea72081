
package io.github.knotresolver.measure;

import java.util.Optional;

import org.apache.commons.math3.stat.regression.SimpleRegression;

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
}
