package io.github.knotresolver.ui;

import java.awt.BorderLayout;
import java.awt.Dimension;
import java.awt.FlowLayout;
import java.awt.event.ActionEvent;
import java.awt.event.KeyEvent;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.awt.event.WindowAdapter;
import java.awt.event.WindowEvent;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Optional;
import java.util.OptionalInt;

import javax.swing.AbstractAction;
import javax.swing.BorderFactory;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JFrame;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.JTable;
import javax.swing.KeyStroke;
import javax.swing.ListSelectionModel;
import javax.swing.SwingUtilities;
import javax.swing.WindowConstants;
import javax.swing.table.AbstractTableModel;

import ij.ImagePlus;
import ij.WindowManager;
import io.github.knotresolver.io.Failure;
import io.github.knotresolver.io.RunIdentity;
import io.github.knotresolver.progress.Progress;
import io.github.knotresolver.ui.model.BatchTable;

/**
 * What came of a batch, movie by movie; a double click, or Enter, opens a result for review. One after
 * the other, those that ask for it are opened: when a review is closed, the next one comes.
 */
public final class BatchWindow {

	private static final int[] WIDTHS = {170, 75, 80, 75, 75, 55, 80, 90, 320};

	private final BatchTable model;
	private final JFrame window;
	private final JTable table;
	private final Cells cells = new Cells();
	private final JLabel status = new JLabel();
	private boolean inTurn;

	private BatchWindow(final String title, final BatchTable model) {
		this.model = model;
		window = new JFrame(title);
		table = new JTable(cells);
	}

	/**
	 * Opens the window. Called by the thread of events.
	 *
	 * @param out the folder of the batch
	 * @param model what came of it
	 */
	public static void open(final Path out, final BatchTable model) {
		new BatchWindow("Batch " + out.getFileName(), model).build();
	}

	private void build() {
		table.setName("outcomes");
		table.setSelectionMode(ListSelectionModel.SINGLE_SELECTION);
		table.setAutoCreateRowSorter(true);
		table.setAutoResizeMode(JTable.AUTO_RESIZE_LAST_COLUMN);
		final int em = table.getFontMetrics(table.getFont()).getHeight();
		table.setRowHeight(em + 4);
		int width = 0;
		for (int c = 0; c < WIDTHS.length; c++) {
			final int wanted = WIDTHS[c] * em / 16;
			table.getColumnModel().getColumn(c).setPreferredWidth(wanted);
			width += wanted;
		}
		table.addMouseListener(new MouseAdapter() {

			@Override
			public void mouseClicked(final MouseEvent e) {
				if (e.getClickCount() == 2)
					reviewSelected();
			}
		});
		table.getInputMap(JComponent.WHEN_ANCESTOR_OF_FOCUSED_COMPONENT)
			.put(KeyStroke.getKeyStroke(KeyEvent.VK_ENTER, 0), "review");
		table.getActionMap().put("review", new AbstractAction() {

			private static final long serialVersionUID = 1L;

			@Override
			public void actionPerformed(final ActionEvent e) {
				reviewSelected();
			}
		});
		final JScrollPane scroll = new JScrollPane(table);
		scroll.setPreferredSize(
			new Dimension(width, Math.min(24, Math.max(6, model.size() + 2)) * (em + 4)));
		status.setText(model.summary());
		status.setName("status");
		final JPanel all = new JPanel(new BorderLayout(6, 6));
		all.setBorder(BorderFactory.createEmptyBorder(8, 8, 8, 8));
		all.add(status, BorderLayout.NORTH);
		all.add(scroll, BorderLayout.CENTER);
		all.add(buttons(), BorderLayout.SOUTH);
		window.setContentPane(all);
		window.setDefaultCloseOperation(WindowConstants.DISPOSE_ON_CLOSE);
		window.addWindowListener(new WindowAdapter() {

			@Override
			public void windowClosed(final WindowEvent e) {
				inTurn = false;
				WindowManager.removeWindow(window);
			}
		});
		window.pack();
		WindowManager.addWindow(window);
		window.setLocationByPlatform(true);
		window.setVisible(true);
	}

	private JPanel buttons() {
		final JPanel buttons = new JPanel(new FlowLayout(FlowLayout.RIGHT, 4, 0));
		final JButton one = new JButton("Review"), all = new JButton(
			model.isAnyByHand() ? "Review those asked for by hand" : "Review all doubtful");
		one.setName("Review");
		one.setToolTipText("Open the chosen result (double click, or Enter)");
		one.addActionListener(e -> reviewSelected());
		all.setName("Review in turn");
		all.setToolTipText("One after the other: when a review is closed, the next one opens");
		all.setEnabled(model.next(-1).isPresent());
		all.addActionListener(e -> {
			inTurn = true;
			goOn(-1);
		});
		buttons.add(one);
		buttons.add(all);
		return buttons;
	}

	private void reviewSelected() {
		if (table.getSelectedRow() < 0)
			status.setText("Choose a movie first.");
		else {
			inTurn = false;
			review(table.convertRowIndexToModel(table.getSelectedRow()));
		}
	}

	private void goOn(final int after) {
		final OptionalInt next = model.next(after);
		if (next.isEmpty()) {
			inTurn = false;
			status.setText("All have been reviewed. " + model.summary());
			window.toFront();
			return;
		}
		final int row = table.convertRowIndexToView(next.getAsInt());
		table.setRowSelectionInterval(row, row);
		review(next.getAsInt());
	}

	/** Opening reads the movie, which takes its time. */
	private void review(final int row) {
		if (model.folder(row).isEmpty()) {
			status.setText("There is no result: " + model.cell(row, WIDTHS.length - 1));
			return;
		}
		status.setText("Opening " + model.cell(row, 0) + " ...");
		final Path folder = model.folder(row).get();
		new Thread(() -> {
			String outcome = model.summary();
			try {
				final Optional<Path> movie = RunIdentity.read(folder).map(RunIdentity::movie);
				final boolean wasOpen = movie.flatMap(ShownFrame::image).isPresent();
				Reviews.open(folder, false, Progress.NONE, () -> SwingUtilities.invokeLater(() -> {
					// Of thirty movies in turn, not all are kept open.
					if (inTurn && !wasOpen)
						movie.flatMap(ShownFrame::image).ifPresent(ImagePlus::close);
					closed(row);
				}));
			} catch (final IOException | RuntimeException | Error e) {
				outcome = Failure.of(e, "give ImageJ more memory").sentence();
			}
			final String words = outcome;
			SwingUtilities.invokeLater(() -> status.setText(words));
		}, "KnotResolver review of a batch").start();
	}

	private void closed(final int row) {
		model.refresh(row);
		cells.fireTableRowsUpdated(row, row);
		if (inTurn && window.isShowing())
			goOn(row);
		else {
			status.setText(model.summary());
			window.toFront();
		}
	}

	/** The model as Swing asks for it. */
	private final class Cells extends AbstractTableModel {

		private static final long serialVersionUID = 1L;

		@Override
		public int getRowCount() {
			return model.size();
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
			return BatchTable.isNumber(column) ? Integer.class : String.class;
		}

		@Override
		public Object getValueAt(final int row, final int column) {
			final Object cell = model.cell(row, column);
			return BatchTable.isNumber(column) && cell.equals("") ? null : cell;
		}
	}
}
