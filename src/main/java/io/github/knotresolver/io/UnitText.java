
package io.github.knotresolver.io;

import java.util.Locale;

import io.github.knotresolver.model.Calibration;

/** The many spellings of a unit, brought down to one. */
public final class UnitText {

	private UnitText() {
	}

	/**
	 * @param unit a unit of length as an image or a person writes it; may be null
	 * @return {@code µm} for micrometres, {@code pixel} for none, else the text
	 */
	public static String length(final String unit) {
		if (unit == null || unit.isBlank())
			return Calibration.NONE.unit();
		return switch (unit.strip().toLowerCase(Locale.ROOT)) {
			case "micron", "microns", "micrometer", "micrometers", "micrometre", "um", "\u00b5m",
				"\u03bcm", "\\u00b5m" -> "\u00b5m";
			case "pixel", "pixels", "px" -> Calibration.NONE.unit();
			case "nanometer", "nanometers", "nanometre" -> "nm";
			default -> unit.strip();
		};
	}

	/**
	 * @param unit a unit of time as an image writes it; may be null
	 * @return {@code s} for seconds, {@code ms} for milliseconds, else the text
	 */
	public static String time(final String unit) {
		if (unit == null || unit.isBlank())
			return "s";
		return switch (unit.strip().toLowerCase(Locale.ROOT)) {
			case "sec", "secs", "second", "seconds", "s" -> "s";
			case "msec", "millisecond", "milliseconds", "ms" -> "ms";
			case "minute", "minutes", "min" -> "min";
			default -> unit.strip();
		};
	}
}
