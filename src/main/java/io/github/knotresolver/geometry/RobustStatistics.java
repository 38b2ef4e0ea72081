package io.github.knotresolver.geometry;

import java.util.Arrays;
import java.util.List;

/**
 * What medians say of a normal distribution. Source: P. J. Rousseeuw and C. Croux,
 * Alternatives to the Median Absolute Deviation, J. Am. Stat. Assoc. 88 (1993) 1273-1283,
 * doi:10.1080/01621459.1993.10476408.
 */
public final class RobustStatistics {

	/** Standard deviation over median absolute deviation. */
	public static final double MAD_TO_SD = 1.4826;

	/** Standard error of a median over that of a mean: the root of half of pi. */
	public static final double MEDIAN_TO_MEAN_ERROR = 1.2533;

	private RobustStatistics() {
	}

	/**
	 * @param values in any order; not changed
	 * @return the middle one, or the mean of the two in the middle; NaN if there is none. O(n log n)
	 */
	public static double median(final double[] values) {
		return median(values, Double.NaN);
	}

	/**
	 * @param values in any order; not changed
	 * @param none the median of nothing
	 * @return the middle one, or the mean of the two in the middle. O(n log n)
	 */
	public static double median(final double[] values, final double none) {
		final double[] sorted = values.clone();
		Arrays.sort(sorted);
		return sorted.length == 0
			? none
			: 0.5 * (sorted[(sorted.length - 1) / 2] + sorted[sorted.length / 2]);
	}

	/**
	 * @param values in any order; not changed
	 * @param none the median of nothing
	 * @return the middle one, or the larger of the two in the middle: always one of the values. O(n log n)
	 */
	public static double upperMedian(final double[] values, final double none) {
		final double[] sorted = values.clone();
		Arrays.sort(sorted);
		return sorted.length == 0 ? none : sorted[sorted.length / 2];
	}

	/**
	 * @param places in any order
	 * @return the {@link #median(double[])} of columns and that of rows. O(n log n)
	 */
	public static Point median(final List<Point> places) {
		return new Point(median(places.stream().mapToDouble(Point::x).toArray()),
			median(places.stream().mapToDouble(Point::y).toArray()));
	}

	/**
	 * @param places in any order
	 * @return the {@link #upperMedian upper median} of columns and that of rows; NaN of nothing. O(n
	 *         log n)
	 */
	public static Point upperMedian(final List<Point> places) {
		return new Point(upperMedian(places.stream().mapToDouble(Point::x).toArray(), Double.NaN),
			upperMedian(places.stream().mapToDouble(Point::y).toArray(), Double.NaN));
	}
}
