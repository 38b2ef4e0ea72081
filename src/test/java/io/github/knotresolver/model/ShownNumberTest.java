package io.github.knotresolver.model;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Locale;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class ShownNumberTest {

	@ParameterizedTest
	@CsvSource({"0, 0", "-0.0, 0", "1, 1", "-3, -3", "0.4, 0.4", "1e9, 1000000000",
		"1e12, 1000000000000", "0.1234567, 0.123457", "123456.78, 123457", "1e15, 1e15",
		"1e308, 1e308", "-2.5e20, -2.5e20", "1e-9, 1e-9", "0.0001, 0.0001", "Infinity, Infinity",
		"NaN, NaN"})
	void numbersAreShownAsPeopleWriteThem(final double value, final String shown) {
		final Locale before = Locale.getDefault();
		try {
			Locale.setDefault(Locale.GERMANY);
			assertEquals(shown, ShownNumber.of(value));
		} finally {
			Locale.setDefault(before);
		}
	}
}
