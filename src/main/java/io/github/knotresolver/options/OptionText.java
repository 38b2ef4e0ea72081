
package io.github.knotresolver.options;

import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Locale;
import java.util.OptionalDouble;
import java.util.regex.Pattern;
import java.util.stream.Collectors;

import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.model.Region;
import io.github.knotresolver.model.UserException;

/**
 * What a person types as the value of an option, turned into a value. Every
 * refusal is one sentence that names the key, the text and what was expected.
 */
public final class OptionText {

	private static final Pattern NUMBER = Pattern
		.compile("[+-]?(\\d+\\.?\\d*|\\.\\d+)([eE][+-]?\\d+)?");

	private static final Pattern REGION = Pattern.compile("\\d{1,9}(\\s*,\\s*\\d{1,9}){3}");

	private OptionText() {
	}

	/**
	 * @param key the option's name
	 * @param text what was typed
	 * @return a finite number
	 */
	public static double number(final String key, final String text) {
		return number(key, text, "a number");
	}

	/**
	 * @param key the option's name
	 * @param text what was typed
	 * @param expected what it must be
	 * @return a finite number
	 */
	public static double number(final String key, final String text, final String expected) {
		if (!NUMBER.matcher(CellText.clean(text)).matches()
			|| Double.isInfinite(Double.parseDouble(CellText.clean(text))))
			throw refusal(key, expected, text);
		return Double.parseDouble(CellText.clean(text));
	}

	/**
	 * @param text what was typed
	 * @return whether it is a number
	 */
	public static boolean isNumber(final String text) {
		return NUMBER.matcher(CellText.clean(text)).matches();
	}

	/**
	 * @param key the option's name
	 * @param text what was typed
	 * @return a number above 0
	 */
	public static double positive(final String key, final String text) {
		final double value = number(key, text);
		if (!(value > 0))
			throw refusal(key, "above 0", text);
		return value;
	}

	/**
	 * @param key the option's name
	 * @param text what was typed
	 * @return a whole number
	 */
	public static int wholeNumber(final String key, final String text) {
		final double value = NUMBER.matcher(CellText.clean(text)).matches()
			? Double.parseDouble(CellText.clean(text))
			: Double.NaN;
		if (value != Math.rint(value) || Math.abs(value) > Integer.MAX_VALUE)
			throw refusal(key, "a whole number", text);
		return (int) value;
	}

	/**
	 * @param key the option's name
	 * @param text what was typed
	 * @param least the smallest that is allowed
	 * @return a whole number from there on
	 */
	public static int wholeNumber(final String key, final String text, final int least) {
		final int value = wholeNumber(key, text);
		if (value < least)
			throw refusal(key, "a whole number from " + least + " on", text);
		return value;
	}

	/**
	 * @param key the option's name
	 * @param text what was typed
	 * @return whether it says yes
	 */
	public static boolean flag(final String key, final String text) {
		return switch (CellText.clean(text).toLowerCase(Locale.ROOT)) {
			case "true", "yes", "on", "1" -> true;
			case "false", "no", "off", "0" -> false;
			default -> throw refusal(key, "true or false", text);
		};
	}

	/**
	 * @param <E> the kind of choice
	 * @param key the option's name
	 * @param text what was typed
	 * @param choices the enumeration to choose from
	 * @return the constant of that name, in any case, with _ or -
	 */
	public static <E extends Enum<E>> E choice(final String key, final String text,
		final Class<E> choices) {
		final String name = CellText.clean(text).replace('-', '_');
		for (final E constant : choices.getEnumConstants())
			if (constant.name().equalsIgnoreCase(name))
				return constant;
		throw refusal(
			key, Arrays.stream(choices.getEnumConstants())
				.map(c -> c.name().toLowerCase(Locale.ROOT)).collect(Collectors.joining(" or ")),
			text);
	}

	/**
	 * @param text a number from 0 to 1, or {@code otsu}
	 * @return the threshold; empty for Otsu's
	 */
	public static OptionalDouble threshold(final String text) {
		if (CellText.clean(text).equalsIgnoreCase("otsu"))
			return OptionalDouble.empty();
		final boolean isNumber = NUMBER.matcher(CellText.clean(text)).matches();
		if (!isNumber || !(Double.parseDouble(CellText.clean(text)) >= 0
			&& Double.parseDouble(CellText.clean(text)) <= 1))
			throw refusal("threshold", "a number from 0 to 1, or otsu", text);
		return OptionalDouble.of(Double.parseDouble(CellText.clean(text)));
	}

	/**
	 * @param key the option's name
	 * @param text column and row in pixels: {@code X,Y}
	 * @return the point
	 */
	public static Point point(final String key, final String text) {
		final String[] parts = CellText.clean(text).split("\\s*,\\s*", -1);
		if (parts.length != 2 || !NUMBER.matcher(parts[0]).matches()
			|| !NUMBER.matcher(parts[1]).matches())
			throw refusal(key, "X,Y in pixels, such as 46,90.5", text);
		return new Point(Double.parseDouble(parts[0]), Double.parseDouble(parts[1]));
	}

	/**
	 * @param key the option's name
	 * @param text left column, upper row, width and height in pixels:
	 *          {@code X,Y,WIDTH,HEIGHT}
	 * @return the region
	 */
	public static Region region(final String key, final String text) {
		if (!REGION.matcher(CellText.clean(text)).matches())
			throw refusal(key, "X,Y,WIDTH,HEIGHT in whole pixels, such as 10,0,120,80", text);
		final int[] parts = Arrays.stream(CellText.clean(text).split("\\s*,\\s*"))
			.mapToInt(Integer::parseInt).toArray();
		return new Region(parts[0], parts[1], parts[2], parts[3]);
	}

	/**
	 * @param key the option, for the message
	 * @param text what was typed
	 * @return the file or folder that it names
	 * @throws UserException if no file can have that name
	 */
	public static Path path(final String key, final String text) {
		try {
			return Path.of(text);
		} catch (final InvalidPathException e) {
			throw refusal(key, "the name of a file", text);
		}
	}

	/**
	 * @param key the option's name
	 * @param expected what it must be
	 * @param text what was typed
	 * @return the refusal: one sentence that names all three
	 */
	public static UserException refusal(final String key, final String expected,
		final String text) {
		return new UserException(
			key + " must be " + expected + ", but is '" + CellText.clean(text) + "'.");
	}
}
