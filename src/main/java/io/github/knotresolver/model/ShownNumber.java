package io.github.knotresolver.model;

import java.math.BigDecimal;
import java.math.MathContext;

/** Numbers as sentences for people show them: 0.4, 1000000000, 1e308. */
public final class ShownNumber {

	private static final int DIGITS = 6;
	/** Between these zeros read better than an exponent. */
	private static final double SMALL = 1e-4, LARGE = 1e15;

	private ShownNumber() {
	}

	/**
	 * @param value any number
	 * @return whole numbers in full, others with six significant digits
	 */
	public static String of(final double value) {
		if (!Double.isFinite(value))
			return String.valueOf(value);
		final double size = Math.abs(value);
		if (value == Math.rint(value) && size < LARGE)
			return String.valueOf((long) value);
		final BigDecimal rounded = new BigDecimal(value).round(new MathContext(DIGITS))
			.stripTrailingZeros();
		return size >= SMALL && size < LARGE
			? rounded.toPlainString()
			: rounded.toString().replace("E+", "e").replace('E', 'e');
	}
}
