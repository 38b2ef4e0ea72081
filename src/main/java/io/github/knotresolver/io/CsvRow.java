package io.github.knotresolver.io;

import java.util.List;

import org.apache.commons.csv.CSVRecord;

import io.github.knotresolver.options.CellText;

/**
 * A row of a CSV file.
 *
 * @param line 1-based line of the file where it ends
 * @param cells without spaces of any kind around them
 */
record CsvRow(int line, List<String> cells) {

	CsvRow {
		cells = List.copyOf(cells);
	}

	static CsvRow of(final int line, final CSVRecord record) {
		return new CsvRow(line, record.stream().map(CellText::clean).toList());
	}

	/** @return the number of cells */
	int size() {
		return cells.size();
	}

	/** @return the text of cell i, from 0 */
	String get(final int i) {
		return cells.get(i);
	}

	/**
	 * @return the text of cell i, with a dot if it is one number with a decimal comma: a
	 *         comma that parts cells is not in a cell
	 */
	String number(final int i) {
		return CellText.withDot(get(i));
	}
}
