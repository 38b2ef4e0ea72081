
package io.github.knotresolver.io;

import java.math.BigDecimal;
import java.math.MathContext;
import java.math.RoundingMode;

/** Numbers as files hold them: a dot, no grouping, in any locale. */
public final class NumberText {

	private static final int SIX = 6;
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
		return Math.abs(value) < NOTHING ? "0" : significant(value, SIX);
	}

	/**
	 * @param value any number
	 * @param digits how many
	 * @return it with that many significant digits; empty if it is not finite
	 */
	public static String significant(final double value, final int digits) {
		if (!Double.isFinite(value))
			return "";
		final BigDecimal rounded = new BigDecimal(value)
			.round(new MathContext(digits, RoundingMode.HALF_EVEN)).stripTrailingZeros();
		return Math.abs(value) < LARGE ? rounded.toPlainString() : rounded.toString();
	}
}
