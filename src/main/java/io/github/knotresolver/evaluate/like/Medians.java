package io.github.knotresolver.evaluate.like;

import java.util.Arrays;

import org.apache.commons.math3.stat.descriptive.rank.Median;

import io.github.knotresolver.geometry.RobustStatistics;

/** Medians, and spreads that outliers leave alone. */
final class Medians {

	private Medians() {
	}

	/** @return the median; NaN of nothing */
	static double of(final double[] values) {
		return new Median().evaluate(values);
	}

	/** @return the median of the first {@code count} values */
	static double of(final double[] values, final int count) {
		return of(Arrays.copyOf(values, count));
	}

	/** @return the standard deviation of values around 0, from their median magnitude */
	static double spread(final double[] values) {
		return RobustStatistics.MAD_TO_SD * of(Arrays.stream(values).map(Math::abs).toArray());
	}
}
