package io.github.knotresolver.imagej;

import ij.measure.ResultsTable;

/**
 * Writes numbers with a fixed number of decimals as ImageJ's tables do, many
 * times faster.
 */
final class FixedPoint {

	/**
	 * What is larger, nearer to a tie, or too small for the decimals (ImageJ writes
	 * 5.000E-4), is left to ImageJ.
	 */
	private static final double LARGEST = 1e9, NEAR_TIE = 1e-4;

	private final int decimals;
	private final long unit;

	/** @param decimals digits after the point, 0..9 */
	FixedPoint(final int decimals) {
		this.decimals = decimals;
		this.unit = Math.round(Math.pow(10, decimals));
	}

	/** Appends the number, rounded to the last decimal; NaN as it is. */
	void append(final StringBuilder text, final double value) {
		final double scaled = Math.abs(value) * unit;
		final long rounded = (long) (scaled + 0.5);
		final boolean tie = Math.abs(Math.abs(scaled - rounded) - 0.5) < NEAR_TIE;
		if (!(scaled < LARGEST) || tie || scaled > 0 && scaled < 1) {
			text.append(ResultsTable.d2s(value, decimals));
			return;
		}
		if (Math.copySign(1, value) < 0)
			text.append('-');
		text.append(rounded / unit);
		if (decimals == 0)
			return;
		text.append('.');
		final long part = rounded % unit;
		for (long digit = unit / 10; digit > 0; digit /= 10)
			text.append((char) ('0' + part / digit % 10));
	}
}
