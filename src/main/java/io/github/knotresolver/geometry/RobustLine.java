package io.github.knotresolver.geometry;

/**
 * A line through values of which up to a quarter may be anything (P. K. Sen,
 * doi:10.1080/01621459.1968.10480934).
 *
 * @param start value at 0
 * @param slope change of the value by 1
 */
public record RobustLine(double start, double slope) {

	/**
	 * The median of the slopes of all pairs, and of what is left. O(n²) for n values.
	 *
	 * @param at where the values are, increasing
	 * @param values one for each place
	 * @return the line; level through 0 if there are no values
	 */
	public static RobustLine through(final double[] at, final double[] values) {
		final int n = values.length;
		final double[] slopes = new double[n * (n - 1) / 2];
		int count = 0;
		for (int i = 0; i < n; i++)
			for (int j = i + 1; j < n; j++)
				slopes[count++] = (values[j] - values[i]) / (at[j] - at[i]);
		final double slope = count == 0 ? 0 : RobustStatistics.median(slopes);
		final double[] left = new double[n];
		for (int i = 0; i < n; i++)
			left[i] = values[i] - slope * at[i];
		return new RobustLine(n == 0 ? 0 : RobustStatistics.median(left), slope);
	}

	/** @return the value at a place */
	public double at(final double place) {
		return start + slope * place;
	}
}
