package io.github.knotresolver.evaluate.like;

import org.apache.commons.math3.stat.interval.ConfidenceInterval;
import org.apache.commons.math3.stat.interval.WilsonScoreInterval;

/**
 * A share of frames, in percent, with the interval that holds it with 95 %
 * confidence. Frames of one movie fail together, so they count for less than
 * independent ones: the Wilson score interval is taken with as many frames as
 * are left after division by the design effect 1 + (n - 1) ρ, where n is the
 * number of frames of a movie and ρ the intraclass correlation (analysis of
 * variance; Kish 1965, Survey Sampling), at least 0.05, as few movies cannot show
 * that there is none.
 *
 * @param percent the share; NaN of no frame
 * @param low lower end of the interval in percent
 * @param high upper end in percent
 */
public record ClusteredProportion(double percent, double low, double high) {

	private static final double LEAST_CORRELATION = 0.05, CONFIDENCE = 0.95;

	/**
	 * @param successes number of frames that count, of every movie
	 * @param trials number of frames, of every movie
	 * @return the share of all frames
	 */
	static ClusteredProportion of(final int[] successes, final int[] trials) {
		int n = 0, k = 0, movies = 0;
		for (int i = 0; i < trials.length; i++) {
			n += trials[i];
			k += successes[i];
			movies += trials[i] > 0 ? 1 : 0;
		}
		if (n == 0)
			return new ClusteredProportion(Double.NaN, Double.NaN, Double.NaN);
		final double p = (double) k / n, size = (double) n / movies;
		final double rho = Math.max(LEAST_CORRELATION, correlation(successes, trials, p, movies));
		final double effective = n / (1 + (size - 1) * rho);
		final int m = (int) Math.max(1, Math.rint(effective));
		// Whole successes are what the library takes; the share itself stays inside.
		final ConfidenceInterval interval = new WilsonScoreInterval().createInterval(m,
			(int) Math.rint(p * m), CONFIDENCE);
		return new ClusteredProportion(100 * p, 100 * Math.min(p, interval.getLowerBound()),
			100 * Math.max(p, interval.getUpperBound()));
	}

	private static double correlation(final int[] successes, final int[] trials, final double p,
		final int movies) {
		double between = 0, within = 0, n = 0, squares = 0;
		for (int i = 0; i < trials.length; i++)
			if (trials[i] > 0) {
				final double own = (double) successes[i] / trials[i];
				between += trials[i] * (own - p) * (own - p);
				within += trials[i] * own * (1 - own);
				n += trials[i];
				squares += (double) trials[i] * trials[i];
			}
		if (movies < 2 || n <= movies)
			return 0;
		final double msb = between / (movies - 1), msw = within / (n - movies);
		final double size = (n - squares / n) / (movies - 1);
		final double all = msb + (size - 1) * msw;
		return all > 0 ? (msb - msw) / all : 0;
	}
}
