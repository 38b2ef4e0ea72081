
package io.github.knotresolver.options;

import java.util.Locale;
import java.util.Map;
import java.util.OptionalDouble;

import io.github.knotresolver.model.Calibration;

/** The many spellings of a unit, brought down to one, and how large it is. */
public final class UnitText {

	/** Micrometres. */
	public static final String MICROMETRE = "\u00b5m";
	/** Seconds. */
	public static final String SECOND = "s";

	private static final Map<String, Double> MICROMETRES = Map.of(MICROMETRE, 1.0, "nm", 1e-3, "pm",
		1e-6, "\u00c5", 1e-4, "mm", 1e3, "cm", 1e4, "m", 1e6, "inch", 25_400.0);
	private static final Map<String, Double> SECONDS = Map.of(SECOND, 1.0, "ms", 1e-3, "\u00b5s",
		1e-6, "ns", 1e-9, "min", 60.0, "h", 3600.0, "d", 86_400.0);

	private UnitText() {
	}

	/**
	 * @param unit a unit of length as an image or a person writes it; may be null
	 * @return {@code µm} for micrometres in any spelling, also where a letter was lost
	 *         between character sets; likewise {@code nm}, {@code mm}, {@code cm},
	 *         {@code m}, {@code pm}, {@code Å}, {@code inch}; {@code pixel} for none,
	 *         else the text
	 */
	public static String length(final String unit) {
		return switch (plain(unit)) {
			case "", "pixel", "px", "none", "unit" -> Calibration.NONE.unit();
			case "micron", "micrometer", "micrometre", "mikrometer", "um", "u", "mic", "?m",
				"mkm" -> MICROMETRE;
			case "nm", "nanometer", "nanometre" -> "nm";
			case "pm", "picometer", "picometre" -> "pm";
			case "\u00e5", "a", "angstrom", "\u00e5ngstr\u00f6m" -> "\u00c5";
			case "mm", "millimeter", "millimetre" -> "mm";
			case "cm", "centimeter", "centimetre" -> "cm";
			case "m", "meter", "metre" -> "m";
			case "inch", "inche", "in", "\"" -> "inch";
			default -> unit.strip();
		};
	}

	/**
	 * @param unit a unit of time as an image writes it; may be null
	 * @return {@code s} for seconds in any spelling and for none; likewise {@code ms},
	 *         {@code µs}, {@code ns}, {@code min}, {@code h}, {@code d}; {@code frame} for
	 *         frames, else the text
	 */
	public static String time(final String unit) {
		return switch (plain(unit)) {
			case "", "sec", "second", "s", "sek", "sekunde" -> SECOND;
			case "msec", "millisecond", "ms" -> "ms";
			case "usec", "microsecond", "us", "?s" -> "\u00b5s";
			case "nsec", "nanosecond", "ns" -> "ns";
			case "minute", "min" -> "min";
			case "hour", "hr", "h" -> "h";
			case "day", "d" -> "d";
			case "frame" -> Calibration.NONE.timeUnit();
			default -> unit.strip();
		};
	}

	/**
	 * Lower case, no dot, no plural. All that became of a µ is {@code u}: the micro
	 * sign, the Greek letter, their bytes read as Latin-1, an escape. What was lost
	 * altogether is a question mark.
	 */
	private static String plain(final String unit) {
		if (unit == null)
			return "";
		final String text = CellText.clean(unit).toLowerCase(Locale.ROOT).replaceAll(
			"\\\\u00b5|\u00e2?\u00c2\u00b5|\u00e2\u00b5|\u00ee\u00bc|\u00ce\u00bc|[\u00b5\u03bc]",
			"u").replaceAll("[?\ufffd]+", "?").replaceAll("\\.$", "");
		return text.length() > 2 ? text.replaceAll("s$", "") : text;
	}

	/**
	 * @param unit a unit as {@link #length(String)} gives it
	 * @return how many micrometres it is; empty if it is none of length
	 */
	public static OptionalDouble micrometres(final String unit) {
		final Double size = MICROMETRES.get(unit);
		return size == null ? OptionalDouble.empty() : OptionalDouble.of(size);
	}

	/**
	 * @param unit a unit as {@link #time(String)} gives it
	 * @return how many seconds it is; empty if it is none of time
	 */
	public static OptionalDouble seconds(final String unit) {
		final Double size = SECONDS.get(unit);
		return size == null ? OptionalDouble.empty() : OptionalDouble.of(size);
	}
}
