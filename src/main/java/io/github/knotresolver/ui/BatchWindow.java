package io.github.knotresolver.ui;

import java.awt.BorderLayout;
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
import java.util.function.Consumer;

import javax.swing.AbstractAction;
import javax.swing.BorderFactory;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JFrame;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.KeyStroke;
import javax.swing.SwingUtilities;
import javax.swing.WindowConstants;

import ij.ImagePlus;
import ij.WindowManager;
import ij.plugin.BrowserLauncher;
import io.github.knotresolver.io.BatchList;
import io.github.knotresolver.io.Failure;
import io.github.knotresolver.io.RunIdentity;
import io.github.knotresolver.model.UserException;
import io.github.knotresolver.progress.Progress;
import io.github.knotresolver.ui.model.BatchTable;

/**
 * What came of a batch, movie by movie; a double click, or Enter, opens a result for review. One after
 * the other, those that ask for it are opened: when a review is closed, the next one comes.
 */
public final class BatchWindow {

	private final BatchTable model;
	private final Optional<JFrame> window;
	private final OutcomesTable table;
	private final JLabel status = new JLabel();
	private boolean inTurn;

	/** @param window shows it; empty if none does */
	BatchWindow(final BatchTable model, final Optional<JFrame> window) {
		this.model = model;
		this.window = window;
		table = new OutcomesTable(model);
	}

	/**
	 * Opens the window. Called by the thread of events.
	 *
	 * @param out the folder of the batch
	 * @param model what came of it
	 */
	public static void open(final Path out, final BatchTable model) {
		final JFrame frame = new JFrame("Batch " + out.getFileName());
		new BatchWindow(model, Optional.of(frame)).show(frame);
	}

	private void show(final JFrame frame) {
		frame.setContentPane(panel(BatchWindow::browse));
		frame.setDefaultCloseOperation(WindowConstants.DISPOSE_ON_CLOSE);
		frame.addWindowListener(new WindowAdapter() {

			@Override
			public void windowClosed(final WindowEvent e) {
				inTurn = false;
				table.close();
				WindowManager.removeWindow(frame);
			}
		});
		WindowActions.onKey(frame.getRootPane(), "ESCAPE", frame::dispose);
		GuiFont.scale(frame.getContentPane());
		frame.pack();
		Beside.keepOnScreen(frame);
		WindowManager.addWindow(frame);
		frame.setLocationByPlatform(true);
		frame.setVisible(true);
		new Thread(table::readPictures, "KnotResolver pictures").start();
	}

	/**
	 * @param browser shows a page, and fails in one sentence if it cannot
	 * @return all that the window shows
	 */
	JPanel panel(final Consumer<Path> browser) {
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
		scroll.setPreferredSize(table.fitting());
		status.setText(model.summary());
		status.setName("status");
		final JPanel all = new JPanel(new BorderLayout(6, 6));
		all.setBorder(BorderFactory.createEmptyBorder(8, 8, 8, 8));
		all.add(status, BorderLayout.NORTH);
		all.add(scroll, BorderLayout.CENTER);
		all.add(buttons(browser), BorderLayout.SOUTH);
		return all;
	}

	private JPanel buttons(final Consumer<Path> browser) {
		final JPanel buttons = new JPanel(new FlowLayout(FlowLayout.RIGHT, 4, 0));
		final JButton page = button("HTML report",
			"All results on one page, " + BatchList.PAGE + ", in the browser");
		page.setEnabled(model.page().isPresent());
		page.addActionListener(e -> report(browser));
		final JButton one = button("Review", "Open the chosen result (double click, or Enter)");
		one.addActionListener(e -> reviewSelected());
		final JButton all = button("Review in turn",
			"One after the other: when a review is closed, the next one opens");
		all.setText(model.isAnyByHand() ? "Review those asked for by hand" : "Review all doubtful");
		all.setEnabled(model.next(-1).isPresent());
		all.addActionListener(e -> {
			inTurn = true;
			goOn(-1);
		});
		buttons.add(page);
		buttons.add(one);
		buttons.add(all);
		return buttons;
	}

	private static JButton button(final String name, final String help) {
		final JButton button = new JButton(name);
		button.setName(name);
		button.setToolTipText(help);
		return button;
	}

	private void report(final Consumer<Path> browser) {
		if (model.page().isEmpty()) {
			status.setText("The page " + BatchList.PAGE
				+ " is not in the folder any more; run the batch again, which skips what is finished.");
			return;
		}
		final Path file = model.page().get();
		try {
			browser.accept(file);
			status.setText("In the browser: " + file);
		} catch (final UserException e) {
			status.setText(e.getMessage());
		}
	}

	private static void browse(final Path page) {
		try {
			BrowserLauncher.openURL(page.toUri().toString());
		} catch (final IOException e) {
			throw new UserException(
				"No browser could be started; open " + page + " in one yourself.", e);
		}
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
			window.ifPresent(JFrame::toFront);
			return;
		}
		final int row = table.convertRowIndexToView(next.getAsInt());
		table.setRowSelectionInterval(row, row);
		review(next.getAsInt());
	}

	/** Opening reads the movie, which takes its time. */
	private void review(final int row) {
		if (model.folder(row).isEmpty()) {
			status.setText("There is no result: " + model.cell(row, BatchTable.COLUMNS.size() - 1));
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
		table.refresh(row, () -> {
			if (inTurn && table.isShowing())
				goOn(row);
			else {
				status.setText(model.summary());
				window.ifPresent(JFrame::toFront);
			}
		});
	}
}
