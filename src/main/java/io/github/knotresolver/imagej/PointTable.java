package io.github.knotresolver.imagej;

import java.util.ArrayList;
import java.util.List;

import ij.WindowManager;
import ij.measure.ResultsTable;
import ij.text.TextPanel;
import ij.text.TextWindow;

/**
 * A long table of numbers that ImageJ shows at once: {@link ResultsTable} looks
 * up and formats every cell on its own, which takes half a second for the points
 * of 120 frames. Text and table are the same to the last digit.
 */
final class PointTable {

	private static final int WIDTH = 700, HEIGHT = 500;

	/**
	 * A column.
	 *
	 * @param heading with the unit
	 * @param decimals digits after the point, 0..9
	 * @param values one a row; NaN where there is none
	 */
	record Column(String heading, int decimals, double[] values) {
	}

	private final List<Column> columns;
	private final int rows;

	/** @param columns all of the same length, at least one */
	PointTable(final List<Column> columns) {
		this.columns = columns;
		this.rows = columns.get(0).values().length;
	}

	/** @return ImageJ's table of the values */
	ResultsTable table() {
		final ResultsTable table = new ResultsTable(rows);
		table.setNaNEmptyCells(true);
		table.showRowNumbers(false);
		if (rows > 0)
			for (int c = 0; c < columns.size(); c++) {
				table.setValues(columns.get(c).heading(), columns.get(c).values());
				table.setDecimalPlaces(c, columns.get(c).decimals());
			}
		return table;
	}

	/** Shows it in a window, or in the one that has the title already. */
	void show(final String title) {
		final ResultsTable table = table();
		final TextWindow window = WindowManager.getFrame(title) instanceof TextWindow open
			? open
			: new TextWindow(title, "", WIDTH, HEIGHT);
		final TextPanel panel = window.getTextPanel();
		panel.setColumnHeadings(table.getColumnHeadings());
		panel.setResultsTable(table);
		if (panel.getLineCount() > 0)
			panel.clear();
		lines().forEach(panel::appendWithoutUpdate);
		panel.updateDisplay();
		panel.scrollToTop();
	}

	/** @return one line a row, cells apart by tabs */
	List<String> lines() {
		final List<String> lines = new ArrayList<>(rows);
		final FixedPoint[] formats = columns.stream().map(c -> new FixedPoint(c.decimals()))
			.toArray(FixedPoint[]::new);
		final double[][] values = columns.stream().map(Column::values).toArray(double[][]::new);
		final StringBuilder line = new StringBuilder();
		for (int row = 0; row < rows; row++) {
			line.setLength(0);
			for (int c = 0; c < formats.length; c++) {
				if (c > 0)
					line.append('\t');
				formats[c].append(line, values[c][row]);
			}
			lines.add(line.toString());
		}
		return lines;
	}

	/**
	 * Writes numbers with a fixed number of decimals as ImageJ's tables do, many
	 * times faster.
	 */
	private static final class FixedPoint {

		/**
		 * What is larger, nearer to a tie, or too small for the decimals (ImageJ writes
		 * 5.000E-4), is left to ImageJ.
		 */
		private static final double LARGEST = 1e9, NEAR_TIE = 1e-4;

		private final int decimals;
		private final long unit;

		/** @param decimals digits after the point, 0..9 */
		FixedPoint(final int decimals) {
			this.decimals = decimals;
			this.unit = Math.round(Math.pow(10, decimals));
		}

		/** Appends the number, rounded to the last decimal; NaN as it is. */
		void append(final StringBuilder text, final double value) {
			final double scaled = Math.abs(value) * unit;
			final long rounded = (long) (scaled + 0.5);
			final boolean tie = Math.abs(Math.abs(scaled - rounded) - 0.5) < NEAR_TIE;
			if (!(scaled < LARGEST) || tie || scaled > 0 && scaled < 1) {
				text.append(ResultsTable.d2s(value, decimals));
				return;
			}
			if (Math.copySign(1, value) < 0)
				text.append('-');
			text.append(rounded / unit);
			if (decimals == 0)
				return;
			text.append('.');
			final long part = rounded % unit;
			for (long digit = unit / 10; digit > 0; digit /= 10)
				text.append((char) ('0' + part / digit % 10));
		}
	}
}
