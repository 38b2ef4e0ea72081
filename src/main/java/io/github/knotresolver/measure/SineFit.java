package io.github.knotresolver.measure;

/** Least squares of a cos + b sin + c at one frequency; all values weigh the same. O(values). */
final class SineFit {

	private final TimeSeries series;
	private final double turn;
	private final double[] abc;

	/**
	 * @param series at least one value
	 * @param frequency in 1/unit of time
	 */
	SineFit(final TimeSeries series, final double frequency) {
		this.series = series;
		this.turn = 2 * Math.PI * frequency;
		final double w = 1.0 / series.size();
		double c = 0, s = 0, cc = 0, cs = 0, ss = 0, v = 0, vc = 0, vs = 0;
		for (int i = 0; i < series.size(); i++) {
			final double cos = Math.cos(turn * series.time(i)),
				sin = Math.sin(turn * series.time(i));
			c += w * cos;
			s += w * sin;
			cc += w * cos * cos;
			cs += w * cos * sin;
			ss += w * sin * sin;
			v += w * series.value(i);
			vc += w * series.value(i) * cos;
			vs += w * series.value(i) * sin;
		}
		abc = new SineMoments(c, s, cc - c * c, cs - c * s, ss - s * s).coefficients(v, vc, vs);
	}

	double amplitude() {
		return Math.hypot(abc[0], abc[1]);
	}

	/** @return in radians: value = amplitude cos(2π f t - phase) */
	double phase() {
		return Math.atan2(abc[1], abc[0]);
	}

	/** @return the series less the sine */
	TimeSeries residual() {
		final double[] rest = new double[series.size()];
		for (int i = 0; i < rest.length; i++)
			rest[i] = series.value(i) - abc[0] * Math.cos(turn * series.time(i))
				- abc[1] * Math.sin(turn * series.time(i)) - abc[2];
		return series.with(rest);
	}
}
