package io.github.knotresolver.io;

import java.nio.file.Path;
import java.util.List;
import java.util.Locale;

/**
 * A table of ours whose cells are found by the names of their columns.
 *
 * @param header the names, in lower case
 * @param rows all other rows
 */
record NamedTable(List<String> header, List<CsvFile.Row> rows) {

	/** @throws IllegalArgumentException if the file is empty */
	static NamedTable read(final Path file) {
		final List<CsvFile.Row> all = CsvFile.read(file);
		if (all.isEmpty())
			throw new IllegalArgumentException(file + " is empty.");
		return new NamedTable(
			all.get(0).cells().stream().map(c -> c.toLowerCase(Locale.ROOT)).toList(),
			all.subList(1, all.size()));
	}

	/** @throws IllegalArgumentException if there is no such column */
	String text(final CsvFile.Row row, final String name) {
		final int column = header.indexOf(name);
		if (column < 0 || column >= row.size())
			throw new IllegalArgumentException("There is no column " + name + ".");
		return row.get(column);
	}

	/** NaN where there is none; likewise. */
	double number(final CsvFile.Row row, final String name) {
		final String text = text(row, name);
		return text.isEmpty() ? Double.NaN : Double.parseDouble(text);
	}
}
