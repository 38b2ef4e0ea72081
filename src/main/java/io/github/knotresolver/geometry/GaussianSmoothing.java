
package io.github.knotresolver.geometry;

/** Smoothing of curves that leaves their end points where they are. */
public final class GaussianSmoothing {

	/** The kernel reaches this many standard deviations. */
	private static final double REACH = 3;

	private GaussianSmoothing() {
	}

	/**
	 * Gaussian smoothing over the points' indices. Beyond an end the curve is
	 * continued by point reflection at that end, so the end points stay and the
	 * curve is not shortened there. A curve of radius R shrinks by sigma²/(2R).
	 * O(n sigma).
	 *
	 * @param curve points of nearly equal spacing
	 * @param sigma standard deviation in points, above 0
	 * @return as many points, with the same first and last
	 */
	public static Polyline gaussian(final Polyline curve, final double sigma) {
		if (!(sigma > 0))
			throw new IllegalArgumentException(
				"sigma must be above 0 points, but is " + sigma + ".");
		final double[] kernel = kernel(sigma,
			Math.min((int) Math.ceil(REACH * sigma), curve.size() - 1));
		return Polyline.of(smooth(curve.xs(), kernel), smooth(curve.ys(), kernel));
	}

	/** The right half of the kernel, centre first; the whole sums to 1. */
	private static double[] kernel(final double sigma, final int radius) {
		final double[] half = new double[radius + 1];
		double sum = 0;
		for (int k = 0; k <= radius; k++) {
			half[k] = Math.exp(-0.5 * k * k / (sigma * sigma));
			sum += k == 0 ? half[k] : 2 * half[k];
		}
		for (int k = 0; k <= radius; k++)
			half[k] /= sum;
		return half;
	}

	private static double[] smooth(final double[] v, final double[] kernel) {
		final double[] out = new double[v.length];
		for (int i = 0; i < v.length; i++) {
			double sum = kernel[0] * v[i];
			for (int k = 1; k < kernel.length; k++)
				sum += kernel[k] * (extended(v, i - k) + extended(v, i + k));
			out[i] = sum;
		}
		out[0] = v[0];
		out[v.length - 1] = v[v.length - 1];
		return out;
	}

	private static double extended(final double[] v, final int i) {
		final int last = v.length - 1;
		if (i < 0)
			return 2 * v[0] - v[-i];
		return i > last ? 2 * v[last] - v[2 * last - i] : v[i];
	}
}
