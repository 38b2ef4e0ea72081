package io.github.knotresolver.geometry;

import java.util.function.DoubleBinaryOperator;
import java.util.stream.IntStream;

/**
 * A line through values of which up to a quarter may be anything (P. K. Sen,
 * doi:10.1080/01621459.1968.10480934).
 *
 * @param start value at 0
 * @param slope change of the value by 1
 */
public record RobustLine(double start, double slope) {

	/** Of more values, so many that are spread evenly say the slope as well. */
	private static final int MOST = 500;

	/**
	 * The median of the slopes of all pairs, and of what is left. O(n²) for n values; of more than
	 * {@value #MOST}, only so many are paired.
	 *
	 * @param at where the values are, increasing
	 * @param values one for each place
	 * @return the line; level through 0 if there are no values
	 */
	public static RobustLine through(final double[] at, final double[] values) {
		final int n = values.length;
		final double slope = n < 2
			? 0
			: RobustStatistics.median(slopes(at, values, (a, b) -> b - a));
		final double[] left = new double[n];
		for (int i = 0; i < n; i++)
			left[i] = values[i] - slope * at[i];
		return new RobustLine(n == 0 ? 0 : RobustStatistics.median(left), slope);
	}

	/**
	 * The slopes between all pairs of values; of more than {@value #MOST}, only so many are paired.
	 *
	 * @param at where the values are, increasing
	 * @param values one for each place
	 * @param rise how much more the second of two values is
	 * @return the slopes; none of fewer than two values
	 */
	public static double[] slopes(final double[] at, final double[] values,
		final DoubleBinaryOperator rise) {
		final int[] some = spread(values.length);
		final double[] slopes = new double[some.length * (some.length - 1) / 2];
		int count = 0;
		for (int a = 0; a < some.length; a++)
			for (int b = a + 1; b < some.length; b++) {
				final int i = some[a], j = some[b];
				slopes[count++] = rise.applyAsDouble(values[i], values[j]) / (at[j] - at[i]);
			}
		return slopes;
	}

	/** Indices of all values, or of some that are spread evenly. */
	private static int[] spread(final int n) {
		return n <= MOST
			? IntStream.range(0, n).toArray()
			: IntStream.range(0, MOST).map(i -> (int) ((long) i * (n - 1) / (MOST - 1))).toArray();
	}

	/**
	 * @param place any
	 * @return the value there
	 */
	public double at(final double place) {
		return start + slope * place;
	}
}
