package io.github.knotresolver.image;

import io.github.knotresolver.model.Polarity;

/**
 * What a movie's lines look like, and in which pixels they are looked for: found once for
 * a movie, used in every frame.
 *
 * @param polarity bright or dark, never {@code AUTO}
 * @param sigma standard deviation of the brightness across a line, in the movie's pixels;
 *          its full width at half maximum is 2.355 times that
 * @param binning edge in the movie's pixels of a working pixel, at least 1: wide lines
 *          are looked for in coarser pictures
 * @param filterSigma standard deviation of the filter, in working pixels
 * @param reference usual ridge strength of the movie's line, per working px²; NaN as long
 *          as it is not known
 * @param clarity usual ridge strength in units of noise
 */
public record LineAppearance(Polarity polarity, double sigma, int binning, double filterSigma,
	double reference, double clarity) {

	/** Full width at half maximum of a Gaussian of standard deviation 1. */
	public static final double FULL_WIDTH = 2 * Math.sqrt(2 * Math.log(2));

	public LineAppearance {
		if (polarity == Polarity.AUTO)
			throw new IllegalArgumentException(
				"The polarity of a movie's lines is bright or dark, but is auto.");
		if (!(sigma > 0) || binning < 1 || !(filterSigma > 0))
			throw new IllegalArgumentException(
				"A line has sigma, binning and filter above 0, but they are " + sigma + ", "
					+ binning + " and " + filterSigma + ".");
	}

	/**
	 * A filter as wide as the line, in pictures binned so that the line is about 1.4 pixels wide
	 * (standard deviation; 1.05 to 2.1), if it is that wide at all.
	 *
	 * @param polarity bright or dark
	 * @param sigma of the line, in the movie's pixels
	 * @return a first idea of the lines
	 */
	public static LineAppearance of(final Polarity polarity, final double sigma) {
		final double s = Math.max(sigma, ImageTuning.THINNEST_LINE);
		return binned(polarity, s, (int) Math.rint(s / ImageTuning.COARSE_LINE));
	}

	/**
	 * @return the same lines in pictures that are binned less, so that no line is thinner there than
	 *         1.4 pixels, as if nothing else had been measured: where focus wanders, sharp frames are
	 *         to lose nothing, and blunt lines look wider than they are
	 */
	public LineAppearance finer() {
		return binned(polarity, sigma, (int) (sigma / ImageTuning.COARSE_LINE));
	}

	private static LineAppearance binned(final Polarity polarity, final double sigma,
		final int edge) {
		final int binning = Math.max(1, edge);
		return new LineAppearance(polarity, sigma, binning,
			Math.max(ImageTuning.NARROWEST_FILTER, sigma / binning), Double.NaN,
			ImageTuning.USUAL_CLARITY);
	}

	/**
	 * The narrowest filter that the noise allows: strands that lie close are told apart.
	 *
	 * @param measured usual ridge strength in units of noise, above 0
	 * @return the same lines, looked for with that filter
	 */
	public LineAppearance asFineAsNoiseAllows(final double measured) {
		final double share = Math.min(ImageTuning.WIDE_FILTER,
			Math.max(ImageTuning.NARROW_FILTER, Math.sqrt(ImageTuning.CLEAR_LINE / measured)));
		return new LineAppearance(polarity, sigma, binning,
			Math.max(ImageTuning.NARROWEST_FILTER, share * sigma / binning), reference, measured);
	}

	/**
	 * @param measured the usual ridge strength, per working px²
	 * @return the same lines with that reference
	 */
	public LineAppearance withReference(final double measured) {
		return new LineAppearance(polarity, sigma, binning, filterSigma, measured, clarity);
	}

	/** @return whether the usual strength is known */
	public boolean hasReference() {
		return !Double.isNaN(reference);
	}

	/** @return standard deviation of the line in working pixels */
	public double workingSigma() {
		return sigma / binning;
	}

	/** @return standard deviation of the line as the filter blurs it, in working pixels */
	public double blurredSigma() {
		return Math.hypot(filterSigma, workingSigma());
	}

	/**
	 * The brightness above the background of a line whose ridge strength is the usual one: the
	 * second derivative of a Gaussian profile, blurred by the filter.
	 *
	 * @return in the movie's grey values; NaN as long as the usual strength is not known
	 */
	public double strand() {
		final double t = blurredSigma();
		return reference * t * t * t / workingSigma();
	}

	/** @return full width at half maximum of the line, in the movie's pixels */
	public double width() {
		return FULL_WIDTH * sigma;
	}
}
