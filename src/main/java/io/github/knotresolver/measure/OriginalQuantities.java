package io.github.knotresolver.measure;

import java.util.List;

import io.github.knotresolver.geometry.Polyline;

/**
 * The original tool's quantities, for those who compare with earlier results.
 * They are found from its published files and reproduce lengths and end-to-end
 * distances to rounding. Not recommended: the length is that of the unsmoothed
 * chain of pixels, a staircase that is 5 to 7 % too long; the smoothing
 * (quadratic, over a fifth of the contour's POINTS) draws the ends inwards; the
 * tip angle is folded to ±90°, so that it jumps, and jumps become frequencies.
 * <p>
 * Its tip angle is not published. The nearest that was found is the direction
 * from the third point of the smoothed contour to the tip (correlation with the
 * original 0.98 and 0.73 on its two example movies); the dominant frequency is
 * the highest peak of the Fourier transform of the tip angle, smoothed
 * quadratically over a fifth of the frames.
 *
 * @param frame 1-based numbers of the frames that have a contour
 * @param length length of the unsmoothed contour, in the unit of length
 * @param tipAngle in degrees, y up, folded to -90..90
 * @param smoothTipAngle the same, smoothed over the frames
 * @param endToEnd distance of the smoothed contour's ends, in the unit of
 *          length
 * @param dominantFrequency in 1/unit of time; NaN for fewer than three contours
 */
public record OriginalQuantities(int[] frame, double[] length, double[] tipAngle,
	double[] smoothTipAngle, double[] endToEnd, double dominantFrequency) {

	private static final double PART = 0.2;
	private static final int ORDER = 2;
	/** The point from which the direction of the tip is taken. */
	private static final int FROM = 2;

	/**
	 * @param frames 1-based numbers of the frames
	 * @param contoursPx their contours in pixels, fixed end first, as many
	 * @param pixelSize edge of a pixel
	 * @param interval time between frames
	 * @return the quantities
	 * @throws IllegalArgumentException if there are not as many contours as frames,
	 *           or none
	 */
	public static OriginalQuantities of(final List<Integer> frames, final List<Polyline> contoursPx,
		final double pixelSize, final double interval) {
		final int n = contoursPx.size();
		if (n == 0 || n != frames.size())
			throw new IllegalArgumentException("There are " + frames.size() + " frames and " + n
				+ " contours; the original's statistics need at least one, and as many of both.");
		final double[] length = new double[n], angle = new double[n], ends = new double[n];
		for (int i = 0; i < n; i++) {
			final Polyline c = contoursPx.get(i);
			final double[] x = smoothed(c.xs()), y = smoothed(c.ys());
			final int last = x.length - 1, from = Math.min(FROM, Math.max(0, last - 1));
			length[i] = c.length() * pixelSize;
			ends[i] = Math.hypot(x[last] - x[0], y[last] - y[0]) * pixelSize;
			angle[i] = folded(Math.atan2(y[from] - y[last], x[last] - x[from]));
		}
		final double[] smooth = smoothed(angle);
		return new OriginalQuantities(frames.stream().mapToInt(Integer::intValue).toArray(), length,
			angle, smooth, ends, frequency(smooth, interval));
	}

	/** Savitzky-Golay over the index: quadratic, a fifth of the values. */
	private static double[] smoothed(final double[] values) {
		final int points = 2 * (int) Math.rint((PART * values.length - 1) / 2) + 1;
		if (points <= ORDER)
			return values.clone();
		final Samples samples = Samples.overIndex(values);
		final LocalPolynomial fit = new LocalPolynomial(ORDER);
		final double[] out = new double[values.length];
		for (int i = 0; i < out.length; i++) {
			final int[] w = samples.window(i, points - 1, points);
			fit.fit(samples, w[0], w[1], i, points / 2.0, -1);
			out[i] = fit.y(0);
		}
		return out;
	}

	private static double folded(final double angle) {
		return Math.toDegrees(Math.atan(Math.tan(angle)));
	}

	private static double frequency(final double[] values, final double interval) {
		final int n = values.length;
		if (n < 3)
			return Double.NaN;
		final FrequencyGrid grid = new FrequencyGrid(1, n / 2, n, interval);
		final TimeSeries series = TimeSeries.of(values, interval);
		final double[] amplitude = SineFits.plain(series, grid).amplitudes(series);
		int best = 0;
		for (int k = 1; k < amplitude.length; k++)
			if (amplitude[k] > amplitude[best])
				best = k;
		return grid.frequency(best);
	}
}
