package io.github.knotresolver.evaluate.like;

import java.util.ArrayList;
import java.util.List;

import io.github.knotresolver.fit.SimplexSearch;
import io.github.knotresolver.progress.Progress;

/**
 * Brightness across a line: a core and a halo, both Gaussian, so that it is also
 * the picture of a line under a point spread function of two Gaussians. Fitted
 * to medians over distance. Where the picture is cut off, or strands that cross
 * are not brighter, the line's middle says only that it is at least as bright.
 *
 * @param core brightness of the core on the line's middle
 * @param coreSigma width of the core in pixels
 * @param halo brightness of the halo on the line's middle
 * @param haloSigma width of the halo in pixels
 */
record LineProfile(double core, double coreSigma, double halo, double haloSigma) {

	/** Width of a bin of distance in pixels. */
	static final double BIN = 0.5;

	private static final double LEAST_SIGMA = 0.4, MOST_SIGMA = 6;

	/** The halo is this much wider than the core. */
	private static final double LEAST_RATIO = 1.5, MOST_RATIO = 4;

	/** Weight of being dim, where the picture is cut off and does not tell. */
	private static final double FAINTNESS = 1e-3;

	private static final int MOST_EVALUATIONS = 4000;

	/** Starts of the search: width of the core in units of the guess. */
	private static final List<Double> STARTS = List.of(0.6, 0.8, 1.0);

	/**
	 * @param medians brightness above the background by bins of {@link #BIN}
	 *          pixels of distance; NaN where there is none
	 * @param ceiling brightness that a line cannot show to be exceeded; infinite
	 *          for none
	 * @param sigma about the width of the line in pixels
	 * @param progress may cancel
	 * @return the profile
	 */
	static LineProfile fit(final double[] medians, final double ceiling, final double sigma,
		final Progress progress) {
		final List<LineProfile> fits = new ArrayList<>();
		for (final double start : STARTS) {
			final double[] guess = {Math.log(medians[0]), Math.log(start * sigma),
				Math.log(0.1 * medians[0]), Math.log(2.5)};
			fits.add(of(new SimplexSearch(1e-8, 1e-10, MOST_EVALUATIONS, progress).lowest(
				p -> of(p).misfit(medians, ceiling), guess, new double[]{0.3, 0.2, 0.7, 0.2})));
		}
		return fits.stream()
			.min((a, b) -> Double.compare(a.misfit(medians, ceiling), b.misfit(medians, ceiling)))
			.orElseThrow();
	}

	private static LineProfile of(final double[] p) {
		final double sigma = within(Math.exp(p[1]), LEAST_SIGMA, MOST_SIGMA);
		return new LineProfile(Math.exp(p[0]), sigma, Math.exp(p[2]),
			sigma * within(Math.exp(p[3]), LEAST_RATIO, MOST_RATIO));
	}

	private static double within(final double value, final double low, final double high) {
		return Math.max(low, Math.min(high, value));
	}

	private double misfit(final double[] medians, final double ceiling) {
		double sum = 0;
		for (int i = 0; i < medians.length; i++)
			if (!Double.isNaN(medians[i])) {
				final double model = Math.min(ceiling, at((i + 0.5) * BIN));
				sum += (model - medians[i]) * (model - medians[i]);
			}
		// Of profiles that the cut-off does not tell apart, the dimmest.
		return sum / (medians[0] * medians[0]) + FAINTNESS * (core + halo) / medians[0];
	}

	/** @return brightness at a distance from the line's middle in pixels */
	double at(final double distance) {
		final double d = distance * distance / 2;
		return core * Math.exp(-d / (coreSigma * coreSigma))
			+ halo * Math.exp(-d / (haloSigma * haloSigma));
	}
}
