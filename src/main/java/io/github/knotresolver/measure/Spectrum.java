
package io.github.knotresolver.measure;

/**
 * Amplitude of a quantity against frequency: the generalised Lomb-Scargle
 * periodogram (Zechmeister and Kürster 2009,
 * doi:10.1051/0004-6361:200811296), which fits a sine and a constant at each
 * frequency to the values that are there, so missing frames need no filling
 * in. The straight trend is removed first, and the values are weighted with
 * Hann's window, so a slow drift does not leak into the spectrum. O(n log n) for n
 * frames.
 *
 * @param frequency from one cycle in the movie to half the frame rate, in
 *          1/unit of time, ascending
 * @param amplitude amplitude of the sine, in the unit of the quantity
 */
public record Spectrum(double[] frequency, double[] amplitude) {

	/**
	 * @param values the quantity in each frame, NaN where it is missing
	 * @param interval time between frames, above 0
	 * @return its spectrum; empty if fewer than eight values are present, or they
	 *         lie on a straight line
	 */
	public static Spectrum of(final double[] values, final double interval) {
		final TimeSeries series = TimeSeries.of(values, interval);
		if (series.size() < MeasureTuning.FEWEST_FRAMES)
			return new Spectrum(new double[0], new double[0]);
		final TimeSeries rest = series.detrended();
		if (!rest.isVaried())
			return new Spectrum(new double[0], new double[0]);
		final SineFits fits = SineFits.tapered(rest,
			FrequencyGrid.over(rest.frames(), MeasureTuning.OVERSAMPLING, interval));
		return new Spectrum(fits.grid().frequencies(), fits.amplitudes(rest));
	}

	/** @return number of frequencies */
	public int size() {
		return frequency.length;
	}
}
