
package io.github.knotresolver.measure;

import java.util.Arrays;
import java.util.function.Function;

/**
 * A field over arc length and time on a regular grid.
 *
 * @param step spacing along the filament, in the unit of length; the first
 *          column is the fixed end
 * @param interval time between rows, in the unit of time
 * @param values one row a frame, one column a step; NaN where the frame has no
 *          contour, or beyond its tip
 */
public record Kymograph(double step, double interval, double[][] values) {

	/** @return the field, interpolated linearly along each contour */
	static Kymograph of(final MovieMeasurements movie,
		final Function<FrameMeasurement, double[]> field) {
		final double step = movie.spacing();
		final double longest = movie.measured().stream()
			.mapToDouble(f -> f.geometry().orElseThrow().length()).max().orElseThrow();
		final int columns = (int) Math.floor(longest / step + 1e-9) + 1;
		final double[][] values = movie.frames().stream()
			.map(f -> f.isMeasured() ? row(f, field.apply(f), step, columns) : missing(columns))
			.toArray(double[][]::new);
		return new Kymograph(step, movie.calibration().frameInterval(), values);
	}

	private static double[] missing(final int columns) {
		final double[] row = new double[columns];
		Arrays.fill(row, Double.NaN);
		return row;
	}

	private static double[] row(final FrameMeasurement f, final double[] field, final double step,
		final int columns) {
		final double[] row = missing(columns);
		final double[] s = f.geometry().orElseThrow().arcLength();
		int k = 1;
		for (int j = 0; j < columns && j * step <= s[s.length - 1]; j++) {
			final double at = j * step;
			while (k < s.length - 1 && s[k] < at)
				k++;
			final double width = s[k] - s[k - 1];
			final double part = width > 0 ? (at - s[k - 1]) / width : 0;
			row[j] = field[k - 1] + part * (field[k] - field[k - 1]);
		}
		return row;
	}

	/** @return number of frames */
	public int frames() {
		return values.length;
	}

	/** @return number of places along the filament */
	public int columns() {
		return values[0].length;
	}

	/**
	 * @param column a place along the filament
	 * @return the field there over time; NaN where it is missing
	 */
	public double[] series(final int column) {
		return Arrays.stream(values).mapToDouble(row -> row[column]).toArray();
	}
}
