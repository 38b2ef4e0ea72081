
package io.github.knotresolver.io;

import java.math.BigDecimal;
import java.math.MathContext;
import java.math.RoundingMode;

/** Numbers as files hold them: a dot, no grouping, in any locale. */
public final class NumberText {

	private static final MathContext SIX_DIGITS = new MathContext(6, RoundingMode.HALF_EVEN);
	private static final int PIXEL_DECIMALS = 3;
	/** From here up an exponent reads better than zeros. */
	private static final double LARGE = 1e12;
	/** What is smaller is rounding error. */
	private static final double NOTHING = 1e-9;

	private NumberText() {
	}

	/**
	 * @param value a coordinate in pixels
	 * @return it with three decimals; empty if it is not finite
	 */
	public static String pixels(final double value) {
		return fixed(value, PIXEL_DECIMALS);
	}

	/**
	 * @param value any number
	 * @param decimals how many digits after the dot
	 * @return it with that many decimals; empty if it is not finite
	 */
	public static String fixed(final double value, final int decimals) {
		if (!Double.isFinite(value))
			return "";
		final BigDecimal rounded = new BigDecimal(value).setScale(decimals, RoundingMode.HALF_EVEN);
		return rounded.toPlainString();
	}

	/**
	 * @param value any number
	 * @return it with six significant digits, 0 if it is smaller than 1e-9; empty if
	 *         it is not finite
	 */
	public static String significant(final double value) {
		if (!Double.isFinite(value))
			return "";
		if (Math.abs(value) < NOTHING)
			return "0";
		final BigDecimal rounded = new BigDecimal(value).round(SIX_DIGITS).stripTrailingZeros();
		return Math.abs(value) < LARGE ? rounded.toPlainString() : rounded.toString();
	}
}
