package io.github.knotresolver.imagej.plot;

import java.math.BigDecimal;
import java.math.MathContext;
import java.text.FieldPosition;
import java.text.NumberFormat;
import java.text.ParsePosition;

/** Numbers on axes: a dot in any locale, no needless zeros. */
final class TickFormat extends NumberFormat {

	private static final long serialVersionUID = 1L;
	private static final MathContext DIGITS = new MathContext(6);
	/** Rounding errors of an axis's arithmetic: below this a tick is 0. */
	private static final double NOTHING = 1e-12;

	@Override
	public StringBuffer format(final double number, final StringBuffer to, final FieldPosition at) {
		if (!Double.isFinite(number) || Math.abs(number) < NOTHING)
			return to.append('0');
		final String plain = new BigDecimal(number).round(DIGITS).stripTrailingZeros()
			.toPlainString();
		return to.append(plain.replace('-', '\u2212'));
	}

	@Override
	public StringBuffer format(final long number, final StringBuffer to, final FieldPosition at) {
		return format((double) number, to, at);
	}

	@Override
	public Number parse(final String source, final ParsePosition position) {
		throw new UnsupportedOperationException("Ticks are written, not read.");
	}
}
