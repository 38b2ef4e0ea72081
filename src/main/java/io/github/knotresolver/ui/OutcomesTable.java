package io.github.knotresolver.ui;

import java.awt.Component;
import java.awt.Dimension;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.image.BufferedImage;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import java.util.stream.IntStream;

import javax.swing.JTable;
import javax.swing.ListSelectionModel;
import javax.swing.SwingConstants;
import javax.swing.SwingUtilities;
import javax.swing.table.AbstractTableModel;
import javax.swing.table.DefaultTableCellRenderer;
import javax.swing.table.TableColumn;

import io.github.knotresolver.imagej.SmallPicture;
import io.github.knotresolver.ui.model.BatchTable;

/**
 * What came of a batch, a row a movie, each with a small picture of its contours. Pictures are read in
 * the background; the rows are as high as they need from the beginning.
 */
final class OutcomesTable extends JTable {

	private static final long serialVersionUID = 1L;

	/** Of a font 16 px high. */
	private static final int[] WIDTHS = {150, 70, 75, 75, 75, 50, 75, 80, 85, 300};
	private static final int MESSAGE = BatchTable.COLUMNS.size() - 1;
	private static final int FONT = 16, GAP = 4, PICTURE_LINES = 3;
	/**
	 * Pixels of a picture for one of its column's width: the font may be twice as large, and a pixel
	 * of the window two of the screen.
	 */
	private static final int SHARP = 4;

	private final transient BatchTable outcomes;
	private final transient Map<Integer, BufferedImage> pictures = new HashMap<>();
	private final Cells cells = new Cells();
	private volatile boolean closed;

	OutcomesTable(final BatchTable outcomes) {
		this.outcomes = outcomes;
		setModel(cells);
		setName("outcomes");
		setSelectionMode(ListSelectionModel.SINGLE_SELECTION);
		setAutoCreateRowSorter(true);
		setAutoResizeMode(AUTO_RESIZE_LAST_COLUMN);
		setDefaultRenderer(BufferedImage.class, new Picture());
		setDefaultRenderer(String.class, new Word(SwingConstants.LEFT));
		setDefaultRenderer(Integer.class, new Word(SwingConstants.RIGHT));
		getColumnModel().getColumn(BatchTable.LENGTH)
			.setCellRenderer(new Word(SwingConstants.RIGHT));
		getColumnModel().getColumn(MESSAGE).setCellRenderer(new Message());
		setIntercellSpacing(new Dimension(2 * GAP, 1));
		GuiFont.scale(this);
		GuiFont.scale(getTableHeader());
		final int line = line();
		for (int c = 0; c < WIDTHS.length; c++) {
			final TableColumn column = getColumnModel().getColumn(c);
			column.setPreferredWidth(WIDTHS[c] * line / FONT);
			// More room is for names and messages, and less is theirs.
			if (c != 0 && c != MESSAGE) {
				column.setMinWidth(column.getPreferredWidth());
				column.setMaxWidth(column.getPreferredWidth());
			}
		}
		final boolean drawn = IntStream.range(0, outcomes.size())
			.anyMatch(row -> outcomes.picture(row).isPresent());
		setRowHeight((drawn ? PICTURE_LINES * line : line) + GAP);
	}

	private int line() {
		return getFontMetrics(getFont()).getHeight();
	}

	/** As wide as all columns, and as high as some rows. */
	Dimension fitting() {
		final int rows = Math.min(12 * (PICTURE_LINES * line() + GAP),
			Math.max(6 * (line() + GAP), outcomes.size() * getRowHeight() + 2 * line()));
		return new Dimension(
			IntStream.of(WIDTHS).map(width -> width * line() / FONT).sum() + 2 * line(), rows);
	}

	/** Reads the pictures of all rows, one after the other, and shows each when it is there. */
	void readPictures() {
		for (int row = 0; row < outcomes.size() && !closed; row++)
			readPicture(row);
	}

	/** No more pictures are read. */
	void close() {
		closed = true;
	}

	private void readPicture(final int row) {
		final Optional<BufferedImage> picture = outcomes.picture(row)
			.flatMap(file -> SmallPicture.read(file, SHARP * WIDTHS[BatchTable.PICTURE]));
		SwingUtilities.invokeLater(() -> {
			picture.ifPresentOrElse(p -> pictures.put(row, p), () -> pictures.remove(row));
			cells.fireTableCellUpdated(row, BatchTable.PICTURE);
		});
	}

	/**
	 * Reads in the background what a row's result is now, and shows it.
	 *
	 * @param then what follows, in the thread of events, when the numbers are there
	 */
	void refresh(final int row, final Runnable then) {
		new Thread(() -> {
			outcomes.refresh(row);
			SwingUtilities.invokeLater(() -> {
				cells.fireTableRowsUpdated(row, row);
				then.run();
			});
			readPicture(row);
		}, "KnotResolver picture").start();
	}

	/** The model as Swing asks for it. */
	private final class Cells extends AbstractTableModel {

		private static final long serialVersionUID = 1L;

		@Override
		public int getRowCount() {
			return outcomes.size();
		}

		@Override
		public int getColumnCount() {
			return BatchTable.COLUMNS.size();
		}

		@Override
		public String getColumnName(final int column) {
			return BatchTable.COLUMNS.get(column);
		}

		@Override
		public Class<?> getColumnClass(final int column) {
			if (column == BatchTable.PICTURE)
				return BufferedImage.class;
			return BatchTable.isNumber(column) ? Integer.class : String.class;
		}

		@Override
		public Object getValueAt(final int row, final int column) {
			if (column == BatchTable.PICTURE)
				return pictures.get(row);
			final Object cell = outcomes.cell(row, column);
			return BatchTable.isNumber(column) && cell.equals("") ? null : cell;
		}
	}

	/** In the first line of its row, beside the first of a message. */
	private static final class Word extends DefaultTableCellRenderer {

		private static final long serialVersionUID = 1L;

		Word(final int alignment) {
			setHorizontalAlignment(alignment);
			setVerticalAlignment(TOP);
		}
	}

	/** Words in as many lines as the row has room for; all of them if the mouse rests there. */
	private static final class Message extends DefaultTableCellRenderer {

		private static final long serialVersionUID = 1L;

		Message() {
			setVerticalAlignment(TOP);
		}

		@Override
		public Component getTableCellRendererComponent(final JTable table, final Object value,
			final boolean selected, final boolean focused, final int row, final int column) {
			final String words = "<html>"
				+ value.toString().replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;");
			setToolTipText(words);
			return super.getTableCellRendererComponent(table, words, selected, focused, row,
				column);
		}
	}

	/** A picture as large as its cell allows, undistorted. */
	private static final class Picture extends DefaultTableCellRenderer {

		private static final long serialVersionUID = 1L;

		private transient BufferedImage picture;

		@Override
		public Component getTableCellRendererComponent(final JTable table, final Object value,
			final boolean selected, final boolean focused, final int row, final int column) {
			picture = (BufferedImage) value;
			return super.getTableCellRendererComponent(table, "", selected, focused, row, column);
		}

		@Override
		protected void paintComponent(final Graphics g) {
			super.paintComponent(g);
			if (picture == null)
				return;
			final int across = getWidth() - 2, down = getHeight() - 2;
			final double scale = Math.min((double) across / picture.getWidth(),
				(double) down / picture.getHeight());
			final int width = (int) (scale * picture.getWidth()),
				height = (int) (scale * picture.getHeight());
			((Graphics2D) g).setRenderingHint(RenderingHints.KEY_INTERPOLATION,
				RenderingHints.VALUE_INTERPOLATION_BILINEAR);
			g.drawImage(picture, (getWidth() - width) / 2, (getHeight() - height) / 2, width,
				height, null);
		}
	}
}
