
package io.github.knotresolver.measure;

import java.util.Optional;

import org.apache.commons.math3.exception.TooManyEvaluationsException;
import org.apache.commons.math3.optim.MaxEval;
import org.apache.commons.math3.optim.nonlinear.scalar.GoalType;
import org.apache.commons.math3.optim.univariate.BrentOptimizer;
import org.apache.commons.math3.optim.univariate.SearchInterval;
import org.apache.commons.math3.optim.univariate.UnivariateObjectiveFunction;

/**
 * The frequency at which a quantity oscillates most, and whether it oscillates
 * at all.
 * <p>
 * The peak of the {@link Spectrum} is refined by least squares without window,
 * which is the most exact. The standard error of the frequency of a sine of
 * amplitude A in noise σ over a time T of N values is √(6/N) σ / (π T A)
 * (Montgomery and O'Donoghue 1999, Delta Scuti Star Newsletter 13, 28), widened
 * for noise that is correlated from frame to frame. The false-alarm probability
 * is that of a first-order autoregressive noise of the same variance, memory
 * and missing frames showing a peak that stands out as much, from a fixed
 * number of seeded simulations; see {@link RedNoiseTest}.
 *
 * @param frequency in 1/unit of time
 * @param standardError of the frequency, in 1/unit of time
 * @param amplitude of the sine, in the unit of the quantity
 * @param phase of the sine in radians: value = amplitude cos(2π f t - phase), t
 *          = 0 in the first frame
 * @param falseAlarmProbability 0..1; small if noise alone would not do this
 */
public record DominantFrequency(double frequency, double standardError, double amplitude,
	double phase, double falseAlarmProbability) {

	/** Below this false-alarm probability an oscillation is believed. */
	public static final double SIGNIFICANT = 0.05;

	/**
	 * @param values the quantity in each frame, NaN where it is missing
	 * @param interval time between frames, above 0
	 * @return its dominant frequency; empty if fewer than eight values are
	 *         present, or they lie on a straight line
	 */
	public static Optional<DominantFrequency> of(final double[] values, final double interval) {
		final Spectrum spectrum = Spectrum.of(values, interval);
		if (spectrum.size() == 0)
			return Optional.empty();
		int peak = 0;
		for (int k = 1; k < spectrum.size(); k++)
			if (spectrum.amplitude()[k] > spectrum.amplitude()[peak])
				peak = k;
		final TimeSeries series = TimeSeries.of(values, interval).detrended();
		final double f = refined(series, spectrum.frequency()[peak]);
		final SineFit sine = new SineFit(series, f);
		return Optional.of(new DominantFrequency(f, standardError(series, sine), sine.amplitude(),
			sine.phase(), new RedNoiseTest(series).falseAlarmProbability()));
	}

	/** @return whether noise alone would hardly do this */
	public boolean isSignificant() {
		return falseAlarmProbability < SIGNIFICANT;
	}

	/** The best sine within half a cycle per movie of the peak. */
	private static double refined(final TimeSeries series, final double peak) {
		final double reach = 0.5 / series.duration();
		final double low = Math.max(0.5 / series.duration(), peak - reach);
		final double high = Math.min(0.5 / series.interval(), peak + reach);
		try {
			return new BrentOptimizer(1e-10, 1e-12).optimize(new MaxEval(200), GoalType.MINIMIZE,
				new UnivariateObjectiveFunction(f -> new SineFit(series, f).residual().variance()),
				new SearchInterval(low, high, Math.min(high, peak))).getPoint();
		} catch (final TooManyEvaluationsException e) {
			// Nothing near the peak fits better than the peak itself.
			return peak;
		}
	}

	private static double standardError(final TimeSeries series, final SineFit sine) {
		final TimeSeries noise = sine.residual();
		final int n = series.size();
		final double sigma = Math.sqrt(noise.variance() * n / Math.max(1, n - 5));
		final double rho = Math.max(0, noise.correlation());
		return Math.sqrt(6.0 / n * (1 + rho) / (1 - rho)) * sigma
			/ (Math.PI * series.duration() * sine.amplitude());
	}
}
