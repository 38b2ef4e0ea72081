package io.github.knotresolver.cli;

import java.nio.file.Path;
import java.util.Arrays;
import java.util.Locale;
import java.util.stream.Collectors;

/** What an option takes, in words. */
final class ValueKind {

	private ValueKind() {
	}

	/**
	 * @param type an option's Java type
	 * @return such as {@code a whole number}, or the words to choose from
	 */
	static String of(final Class<?> type) {
		if (type.isEnum())
			return Arrays.stream(type.getEnumConstants())
				.map(c -> c.toString().toLowerCase(Locale.ROOT))
				.collect(Collectors.joining(" or "));
		if (type == Path.class)
			return "a file or folder";
		if (type == boolean.class || type == Boolean.class)
			return "true or false";
		final boolean fractions = type == double.class || type == Double.class;
		return fractions ? "a number" : "a whole number";
	}
}
