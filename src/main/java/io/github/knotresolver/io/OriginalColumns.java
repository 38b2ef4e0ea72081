
package io.github.knotresolver.io;

import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;

/**
 * The original tool's columns, turned into this program's options.
 * {@code False}, {@code 0}, an empty cell and {@code []} mean "none"; of the
 * active contour's numbers, 0 is the number.
 */
final class OriginalColumns {

	/** Their names in lower case. */
	static final Set<String> NAMES = Set.of("segthresh", "segiteration", "segcontract", "segsmooth",
		"requiresmanual", "ignoreframes", "uselogp", "logpk", "logps", "invertmanual",
		"manualcheck");

	private static final List<String> MANUAL = List.of("requiresmanual", "invertmanual",
		"manualcheck");

	private OriginalColumns() {
	}

	/**
	 * @param cells a row's cells by column name in lower case
	 * @param notes gets a sentence for what is done otherwise
	 * @return options by key
	 */
	static Map<String, String> translate(final Map<String, String> cells,
		final List<String> notes) {
		final Map<String, String> texts = new TreeMap<>();
		if (!isNone(cells.get("segthresh")))
			texts.put("threshold", cells.get("segthresh"));
		copy(cells, "segiteration", texts, "iterations");
		copy(cells, "segcontract", texts, "contraction_bias");
		copy(cells, "segsmooth", texts, "smooth_factor");
		if (!isNone(cells.get("ignoreframes")))
			texts.put("ignore_frames", cells.get("ignoreframes"));
		if (!isNone(cells.get("uselogp")))
			enhance(cells, texts, notes);
		for (final String column : MANUAL)
			if (!isNone(cells.get(column)))
				notes.add("The column " + column + " asks for work by hand (" + cells.get(column)
					+ "), which is not needed here; the movie is resolved without it.");
		return texts;
	}

	/** @return whether the row asks for work by hand */
	static boolean isByHand(final Map<String, String> cells) {
		return MANUAL.stream().anyMatch(column -> !isNone(cells.get(column)));
	}

	private static void copy(final Map<String, String> cells, final String column,
		final Map<String, String> texts, final String key) {
		final String text = cells.getOrDefault(column, "");
		if (!text.isBlank() && !text.equals("[]") && !text.equalsIgnoreCase("false"))
			texts.put(key, text);
	}

	/** The kernel's edge must be odd here. */
	private static void enhance(final Map<String, String> cells, final Map<String, String> texts,
		final List<String> notes) {
		final String size = cells.getOrDefault("logpk", "");
		texts.put("log_size", size);
		texts.put("log_sigma", cells.getOrDefault("logps", ""));
		if (!size.matches("\\d{0,3}[02468]"))
			return;
		final String odd = Integer.toString(Integer.parseInt(size) + 1);
		texts.put("log_size", odd);
		notes.add("The kernel's edge logPk must be odd and was raised from " + size + " to " + odd
			+ " pixels.");
	}

	private static boolean isNone(final String cell) {
		if (cell == null)
			return true;
		return switch (cell.strip().toLowerCase(Locale.ROOT)) {
			case "", "false", "[]" -> true;
			default -> cell.strip().matches("[+-]?0*\\.?0+|\\[\\s*0?\\s*]");
		};
	}
}
