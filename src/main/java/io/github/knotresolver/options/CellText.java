package io.github.knotresolver.options;

import java.util.regex.Pattern;

/** Text as spreadsheets and web pages leave it in a cell, made plain. */
public final class CellText {

	/** Spaces of all widths, and marks without width. */
	private static final String SPACE = "[\\s\\p{Z}\\u200B-\\u200D\\u2060\\uFEFF]+";
	private static final Pattern AROUND = Pattern.compile("^" + SPACE + "|" + SPACE + "$");
	private static final Pattern DECIMAL_COMMA = Pattern.compile("[+-]?\\d*,\\d+([eE][+-]?\\d+)?");

	private CellText() {
	}

	/**
	 * @param text of a cell
	 * @return it without spaces of any kind, and marks without width, around it
	 */
	public static String clean(final String text) {
		return AROUND.matcher(text).replaceAll("");
	}

	/**
	 * @param text of a cell
	 * @return whether it is one number with a comma for its dot
	 */
	public static boolean hasDecimalComma(final String text) {
		return DECIMAL_COMMA.matcher(text).matches();
	}

	/**
	 * @param text of a cell
	 * @return it, with a dot in place of the comma if it is such a number
	 */
	public static String withDot(final String text) {
		return hasDecimalComma(text) ? text.replace(',', '.') : text;
	}
}
