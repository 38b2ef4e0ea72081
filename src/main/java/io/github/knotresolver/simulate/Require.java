
package io.github.knotresolver.simulate;

import java.util.Locale;

/** Says in one sentence what is wrong with a parameter. */
final class Require {

	private Require() {
	}

	static double within(final String name, final double value, final double low, final double high,
		final String unit) {
		if (!(value >= low && value <= high))
			throw new IllegalArgumentException(
				String.format(Locale.ROOT, "The %s must be %s to %s%s, but is %s.", name, text(low),
					text(high), unit.isEmpty() ? "" : " " + unit, text(value)));
		return value;
	}

	static int within(final String name, final int value, final int low, final int high) {
		return (int) within(name, (double) value, low, high, "");
	}

	private static String text(final double value) {
		return value == Math.rint(value) && Math.abs(value) < 1e15
			? Long.toString((long) value)
			: Double.toString(value);
	}
}
