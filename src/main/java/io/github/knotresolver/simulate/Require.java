
package io.github.knotresolver.simulate;

import java.util.Locale;

import io.github.knotresolver.model.ShownNumber;
import io.github.knotresolver.model.UserException;

/**
 * Says in one sentence what is wrong with a parameter: its key in macros, which
 * the command line spells as an option, its value, and what is allowed.
 */
final class Require {

	private Require() {
	}

	static double within(final String key, final double value, final double low, final double high,
		final String unit) {
		if (!(value >= low && value <= high))
			throw new UserException(String.format(Locale.ROOT,
				"%s must be %s to %s%s, but is %s; choose a value in that range.", key,
				ShownNumber.of(low), ShownNumber.of(high), unit.isEmpty() ? "" : " " + unit,
				ShownNumber.of(value)));
		return value;
	}

	static int within(final String key, final int value, final int low, final int high) {
		return (int) within(key, (double) value, low, high, "");
	}
}
