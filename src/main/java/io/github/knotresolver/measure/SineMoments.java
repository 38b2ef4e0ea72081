package io.github.knotresolver.measure;

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
record SineMoments(double c, double s, double cc, double cs, double ss) {

	/** Of squares this small a part is rounding. */
	private static final double ROUNDING = 1e-9;

	/**
	 * @param c mean of the cosine
	 * @param s mean of the sine
	 * @param c2 mean of the cosine of twice the angle
	 * @param s2 mean of the sine of twice the angle
	 */
	static SineMoments of(final double c, final double s, final double c2, final double s2) {
		return new SineMoments(c, s, (1 + c2) / 2 - c * c, s2 / 2 - c * s, (1 - c2) / 2 - s * s);
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
			return cc >= ss ? new double[]{one, 0, v - one * c} : new double[]{0, one, v - one * s};
		}
		final double a = (x * ss - y * cs) / determinant;
		final double b = (y * cc - x * cs) / determinant;
		return new double[]{a, b, v - a * c - b * s};
	}
}
