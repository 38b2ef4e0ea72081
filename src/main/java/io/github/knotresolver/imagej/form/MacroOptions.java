package io.github.knotresolver.imagej.form;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.function.UnaryOperator;

import io.github.knotresolver.model.UserException;

/**
 * The options of a macro's {@code run("...", options)}, read strictly: every
 * word is a key, {@code key=value}, {@code key=[a value with spaces]} or
 * {@code key='a value'}; a key alone means yes. Keys are matched as a whole, so
 * {@code frames} is never taken from {@code ignore_frames}. A value
 * {@code &name} is the macro's variable of that name.
 *
 * @param values by key; empty for a key alone
 */
public record MacroOptions(Map<String, Optional<String>> values) {

	public MacroOptions {
		values = Collections.unmodifiableMap(new LinkedHashMap<>(values));
	}

	/**
	 * @param options the text
	 * @param variable gives the value of a macro's variable, or null if there is
	 *          none
	 * @return the options
	 * @throws UserException if they cannot be read, or a key comes
	 *           twice; in one sentence
	 */
	public static MacroOptions parse(final String options, final UnaryOperator<String> variable) {
		return new MacroOptions(new Reader(options, variable).read());
	}

	/** Walks through the text once. */
	private static final class Reader {

		private final String text;
		private final UnaryOperator<String> variable;
		private int at;

		Reader(final String text, final UnaryOperator<String> variable) {
			this.text = text.stripTrailing();
			this.variable = variable;
		}

		Map<String, Optional<String>> read() {
			final Map<String, Optional<String>> values = new LinkedHashMap<>();
			while (at < text.length()) {
				final String key = key();
				if (key.isEmpty() && at == text.length())
					break;
				if (key.isEmpty())
					throw new UserException("There is no key before '" + text.substring(at)
						+ "'; write key=value, or key=[a value] if the value has spaces or '='.");
				final Optional<String> value = isAt('=')
					? Optional.of(resolved(key, value(key)))
					: Optional.empty();
				if (values.put(key, value) != null)
					throw new UserException("The key '" + key + "' is there twice; name it once.");
			}
			return values;
		}

		private String key() {
			while (at < text.length() && Character.isWhitespace(text.charAt(at)))
				at++;
			final int start = at;
			while (at < text.length() && !isAt('=') && !Character.isWhitespace(text.charAt(at)))
				at++;
			return text.substring(start, at).toLowerCase(Locale.ROOT);
		}

		private String value(final String key) {
			at++;
			if (isAt('['))
				return upTo(closing(key));
			if (isAt('\'') && text.indexOf('\'', at + 1) > 0)
				return upTo(text.indexOf('\'', at + 1));
			final int start = at;
			while (at < text.length() && !Character.isWhitespace(text.charAt(at)))
				at++;
			return text.substring(start, at);
		}

		private String upTo(final int end) {
			final String value = text.substring(at + 1, end);
			at = end + 1;
			return value;
		}

		private int closing(final String key) {
			int depth = 0;
			for (int i = at; i < text.length(); i++) {
				if (text.charAt(i) == '[')
					depth++;
				else if (text.charAt(i) == ']' && --depth == 0)
					return i;
			}
			throw new UserException("The value of " + key + " has no closing ']'; add it.");
		}

		private boolean isAt(final char c) {
			return at < text.length() && text.charAt(at) == c;
		}

		private String resolved(final String key, final String value) {
			if (!value.startsWith("&"))
				return value;
			final String found = variable.apply(value.substring(1));
			if (found == null)
				throw new UserException(key + " is " + value
					+ ", but the macro has no variable of that name; define it before.");
			return found;
		}
	}
}
