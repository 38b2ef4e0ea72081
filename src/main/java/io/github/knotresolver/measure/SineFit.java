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
		abc = new Moments(c, s, cc - c * c, cs - c * s, ss - s * s).coefficients(v, vc, vs);
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

	/**
	 * Weighted means of cosine and sine over the times of a series, and their covariances: what the least
	 * squares of a cos + b sin + c need to know of a frequency, whatever the values are.
	 *
	 * @param c mean of the cosine
	 * @param s mean of the sine
	 * @param cc variance of the cosine
	 * @param cs covariance of both
	 * @param ss variance of the sine
	 */
	record Moments(double c, double s, double cc, double cs, double ss) {

		/** Of squares this small a part is rounding. */
		private static final double ROUNDING = 1e-9;

		/**
		 * @param c mean of the cosine
		 * @param s mean of the sine
		 * @param c2 mean of the cosine of twice the angle
		 * @param s2 mean of the sine of twice the angle
		 */
		static Moments of(final double c, final double s, final double c2, final double s2) {
			return new Moments(c, s, (1 + c2) / 2 - c * c, s2 / 2 - c * s, (1 - c2) / 2 - s * s);
		}

		/**
		 * @param v weighted mean of the values
		 * @param vc weighted mean of value times cosine
		 * @param vs weighted mean of value times sine
		 * @return a, b and c of a cos + b sin + c
		 */
		double[] coefficients(final double v, final double vc, final double vs) {
			final double x = vc - v * c, y = vs - v * s;
			final double determinant = cc * ss - cs * cs;
			// At half the frame rate the sine may vanish at every frame.
			if (determinant < ROUNDING * (cc + ss) * (cc + ss)) {
				final double square = Math.max(cc, ss);
				final double one = square > 0 ? (cc >= ss ? x : y) / square : 0;
				return cc >= ss
					? new double[]{one, 0, v - one * c}
					: new double[]{0, one, v - one * s};
			}
			final double a = (x * ss - y * cs) / determinant;
			final double b = (y * cc - x * cs) / determinant;
			return new double[]{a, b, v - a * c - b * s};
		}
	}
}
