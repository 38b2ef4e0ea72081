package io.github.knotresolver.imagej.plot;

import java.util.Arrays;
import java.util.Locale;

import org.apache.commons.math3.stat.StatUtils;

/** How far a histogram of position errors goes, so that a few wrong frames do not squash it. */
final class HistogramRange {

	private static final double LEAST = 1, MEDIANS = 8;

	private HistogramRange() {
	}

	/**
	 * @param errors at least one, in pixels
	 * @return the end of the axis in pixels
	 */
	static double of(final double[] errors) {
		final double most = Math.max(LEAST, MEDIANS * StatUtils.percentile(errors, 50));
		return Math.ceil(most * 2) / 2;
	}

	/**
	 * @param most the end of the axis in pixels
	 * @return the distance of its ticks: some ten of 0.1, 0.2, 0.5, 1, 2, 5, ...
	 */
	static double tick(final double most) {
		double tick = 0.1;
		for (int i = 0; tick * 12 < most; i++)
			tick *= i % 3 == 1 ? 2.5 : 2;
		return tick;
	}

	/**
	 * @param errors at least one, in pixels
	 * @param most the end of the axis
	 * @return the axis' label; it tells how many errors are beyond its end
	 */
	static String label(final double[] errors, final double most) {
		final double beyond = 100.0 * Arrays.stream(errors).filter(e -> e > most).count()
			/ errors.length;
		return beyond == 0
			? "Position error"
			: String.format(Locale.ROOT, "Position error (%.2g %% beyond)", beyond);
	}
}
