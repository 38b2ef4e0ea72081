package io.github.knotresolver.ui;

import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.function.Supplier;

import ij.ImagePlus;
import ij.WindowManager;
import ij.text.TextPanel;
import ij.text.TextWindow;

/** A click on a row of ImageJ's tables shows the row's frame and filament. */
public final class TableClicks {

	private static final String FRAME = "frame", FILAMENT = "filament";

	private TableClicks() {
	}

	/**
	 * @param title a table's title; nothing happens if there is no such window
	 * @param movie finds the image that has the frames, if it is open
	 * @param filament number of the filament of all rows, if they do not tell
	 */
	public static void lead(final String title, final Supplier<Optional<ImagePlus>> movie,
		final int filament) {
		if (!(WindowManager.getFrame(title) instanceof TextWindow window))
			return;
		final TextPanel panel = window.getTextPanel();
		for (final var listener : panel.getComponent(0).getMouseListeners())
			if (listener instanceof Leading)
				panel.getComponent(0).removeMouseListener(listener);
		panel.addMouseListener(new Leading(panel, movie, filament));
	}

	/** One for each table. */
	private static final class Leading extends MouseAdapter {

		private final TextPanel panel;
		private final Supplier<Optional<ImagePlus>> movie;
		private final int filament;

		Leading(final TextPanel panel, final Supplier<Optional<ImagePlus>> movie,
			final int filament) {
			this.panel = panel;
			this.movie = movie;
			this.filament = filament;
		}

		@Override
		public void mouseReleased(final MouseEvent e) {
			final int row = panel.getSelectionStart();
			if (row < 0 || row >= panel.getLineCount())
				return;
			final String headings = panel.getColumnHeadings(), line = panel.getLine(row);
			number(headings, line, FRAME)
				.ifPresent(frame -> ShownFrame.goTo(movie.get().orElse(null),
					number(headings, line, FILAMENT).orElse(filament), frame));
		}
	}

	/**
	 * @param headings names of the columns, apart by tabs
	 * @param line cells, likewise
	 * @param column a name
	 * @return the whole number in that column; empty if there is none
	 */
	static OptionalInt number(final String headings, final String line, final String column) {
		final List<String> names = Arrays.asList(headings.split("\t")),
			cells = Arrays.asList(line.split("\t", -1));
		final int at = names.indexOf(column);
		return at >= 0 && at < cells.size() && cells.get(at).strip().matches("[0-9]{1,7}([.]0*)?")
			? OptionalInt.of((int) Double.parseDouble(cells.get(at).strip()))
			: OptionalInt.empty();
	}
}
