
package io.github.knotresolver.measure;

import java.util.Arrays;

import io.github.knotresolver.progress.Cancellation;

/**
 * Weighted least squares of a cos + b sin + c at many frequencies, prepared for
 * one set of times, so that many series can be fitted quickly.
 */
final class SineFits {

	private final double[] frequencies;
	private final double[] weight;
	private final double[][] cos;
	private final double[][] sin;
	/** Weighted means of cosine and sine, and their covariances, by frequency. */
	private final double[][] means;

	private SineFits(final TimeSeries series, final double[] frequencies, final double[] weight) {
		final int n = series.size();
		double total = 0;
		for (final double w : weight)
			total += w;
		this.weight = weight;
		for (int i = 0; i < n; i++)
			weight[i] /= total;
		this.frequencies = frequencies;
		cos = new double[frequencies.length][n];
		sin = new double[frequencies.length][n];
		means = new double[frequencies.length][];
		for (int k = 0; k < frequencies.length; k++) {
			Cancellation.check();
			for (int i = 0; i < n; i++) {
				final double phase = 2 * Math.PI * frequencies[k] * series.time(i);
				cos[k][i] = Math.cos(phase);
				sin[k][i] = Math.sin(phase);
			}
			means[k] = means(cos[k], sin[k]);
		}
	}

	private double[] means(final double[] c, final double[] s) {
		double mc = 0, ms = 0, cc = 0, cs = 0, ss = 0;
		for (int i = 0; i < c.length; i++) {
			final double w = weight[i];
			mc += w * c[i];
			ms += w * s[i];
			cc += w * c[i] * c[i];
			cs += w * c[i] * s[i];
			ss += w * s[i] * s[i];
		}
		return new double[]{mc, ms, cc - mc * mc, cs - mc * ms, ss - ms * ms};
	}

	/** Weights: Hann's window over the duration of the series. */
	static SineFits tapered(final TimeSeries series, final double[] frequencies) {
		final double[] w = new double[series.size()];
		final double start = series.time(0) - series.interval() / 2;
		for (int i = 0; i < w.length; i++)
			w[i] = Math.pow(Math.sin(Math.PI * (series.time(i) - start) / series.duration()), 2);
		return new SineFits(series, frequencies, w);
	}

	/** All values weigh the same. */
	static SineFits plain(final TimeSeries series, final double... frequencies) {
		final double[] w = new double[series.size()];
		Arrays.fill(w, 1);
		return new SineFits(series, frequencies, w);
	}

	double[] frequencies() {
		return frequencies;
	}

	double[] amplitudes(final TimeSeries series) {
		final double[] out = new double[frequencies.length];
		for (int k = 0; k < out.length; k++) {
			Cancellation.check();
			final double[] c = coefficients(series, k);
			out[k] = Math.hypot(c[0], c[1]);
		}
		return out;
	}

	/** @return a, b and c of a cos + b sin + c at frequency {@code k} */
	double[] coefficients(final TimeSeries series, final int k) {
		final double[] c = cos[k], s = sin[k];
		double mv = 0, vc = 0, vs = 0;
		for (int i = 0; i < c.length; i++) {
			final double v = weight[i] * series.value(i);
			mv += v;
			vc += v * c[i];
			vs += v * s[i];
		}
		final double mc = means[k][0], ms = means[k][1];
		final double cc = means[k][2], cs = means[k][3], ss = means[k][4];
		vc -= mv * mc;
		vs -= mv * ms;
		final double determinant = cc * ss - cs * cs;
		// At half the frame rate the sine may vanish at every frame.
		if (determinant < 1e-9 * (cc + ss) * (cc + ss)) {
			final double square = Math.max(cc, ss);
			final double one = square > 0 ? (cc >= ss ? vc : vs) / square : 0;
			return cc >= ss
				? new double[]{one, 0, mv - one * mc}
				: new double[]{0, one, mv - one * ms};
		}
		final double a = (vc * ss - vs * cs) / determinant;
		final double b = (vs * cc - vc * cs) / determinant;
		return new double[]{a, b, mv - a * mc - b * ms};
	}

	/** @return the series less the sine at frequency {@code k} */
	TimeSeries residual(final TimeSeries series, final int k) {
		final double[] c = coefficients(series, k);
		final double[] rest = new double[series.size()];
		for (int i = 0; i < rest.length; i++)
			rest[i] = series.value(i) - c[0] * cos[k][i] - c[1] * sin[k][i] - c[2];
		return series.with(rest);
	}
}
