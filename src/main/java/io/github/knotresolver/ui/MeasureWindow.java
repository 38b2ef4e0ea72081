package io.github.knotresolver.ui;

import java.awt.BorderLayout;
import java.awt.CardLayout;
import java.awt.Dimension;
import java.awt.FlowLayout;
import java.awt.GridLayout;
import java.awt.event.WindowAdapter;
import java.awt.event.WindowEvent;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Supplier;

import javax.swing.BorderFactory;
import javax.swing.JButton;
import javax.swing.JComboBox;
import javax.swing.JFrame;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.JTabbedPane;
import javax.swing.JTable;
import javax.swing.WindowConstants;
import javax.swing.table.DefaultTableModel;

import ij.ImagePlus;
import ij.WindowManager;
import ij.gui.GUI;
import ij.measure.ResultsTable;
import io.github.knotresolver.imagej.plot.LiveFigure;
import io.github.knotresolver.imagej.plot.LivePlots;
import io.github.knotresolver.measure.MovieMeasurements;
import io.github.knotresolver.ui.model.MeasureTabs;

/**
 * {@code Measure Contours...}: all figures of all filaments in one window, on tabs. A click on a
 * contour, a point over time or a kymograph goes to the frame in the movie.
 */
public final class MeasureWindow {

	/**
	 * What is shown of a filament.
	 *
	 * @param filament its number
	 * @param measurements what was measured
	 */
	public record Item(int filament, MovieMeasurements measurements) {
	}

	private final Supplier<Optional<ImagePlus>> movie;
	private final JFrame window;
	private final JLabel status = new JLabel(
		"Click on a contour, a point or a kymograph to see its frame in the movie.");

	private MeasureWindow(final String title, final Supplier<Optional<ImagePlus>> movie) {
		this.movie = movie;
		window = new JFrame(title);
	}

	/**
	 * Opens the window, in place of an earlier one of the same name. Called by the thread of events.
	 *
	 * @param name what was measured
	 * @param filaments at least one
	 * @param movie finds the movie's image, if it is open
	 */
	public static void open(final String name, final List<Item> filaments,
		final Supplier<Optional<ImagePlus>> movie) {
		new MeasureWindow("Measurements of " + name, movie).build(filaments);
	}

	private void build(final List<Item> filaments) {
		final JPanel all = new JPanel(new BorderLayout(4, 4));
		all.setBorder(BorderFactory.createEmptyBorder(8, 8, 8, 8));
		final CardLayout cards = new CardLayout();
		final JPanel middle = new JPanel(cards);
		final JComboBox<String> choice = new JComboBox<>();
		choice.setName("filament");
		choice.setToolTipText("The filament whose measurements are shown");
		for (final Item item : filaments) {
			final String name = "filament " + item.filament;
			choice.addItem(name);
			middle.add(tabs(item), name);
		}
		choice.addActionListener(e -> cards.show(middle, (String) choice.getSelectedItem()));
		if (filaments.size() > 1)
			all.add(choice, BorderLayout.NORTH);
		all.add(middle, BorderLayout.CENTER);
		status.setName("status");
		all.add(status, BorderLayout.SOUTH);
		window.setContentPane(all);
		window.setDefaultCloseOperation(WindowConstants.DISPOSE_ON_CLOSE);
		window.addWindowListener(new WindowAdapter() {

			@Override
			public void windowClosed(final WindowEvent e) {
				WindowManager.removeWindow(window);
			}
		});
		WindowActions.onKey(window.getRootPane(), "ESCAPE", window::dispose);
		GuiFont.scale(all);
		window.pack();
		final Dimension screen = GUI.getMaxWindowBounds(window).getSize();
		window.setSize(Math.min(screen.width, window.getWidth()),
			Math.min(screen.height, window.getHeight()));
		window
			.setMinimumSize(new Dimension(2 * window.getWidth() / 3, 9 * window.getHeight() / 10));
		if (WindowManager.getFrame(window.getTitle()) instanceof JFrame earlier) {
			window.setLocation(earlier.getLocation());
			WindowManager.removeWindow(earlier);
			earlier.dispose();
		} else
			window.setLocationByPlatform(true);
		WindowManager.addWindow(window);
		window.setVisible(true);
	}

	private JTabbedPane tabs(final Item item) {
		final Map<String, LiveFigure> figures = new LinkedHashMap<>();
		LiveFigure.of(item.measurements).forEach(f -> figures.put(f.key(), f));
		final List<FigurePanel> panels = new ArrayList<>();
		final JTabbedPane tabs = new JTabbedPane();
		tabs.setName("tabs " + item.filament);
		MeasureTabs.of(List.copyOf(figures.keySet())).forEach((tab, keys) -> {
			final JPanel page = new JPanel(new GridLayout(0, 1, 4, 4));
			for (final String key : keys) {
				final FigurePanel panel = new FigurePanel(figures.get(key),
					frame -> goTo(item.filament, frame, panels), status::setText);
				panels.add(panel);
				page.add(panel);
			}
			tabs.addTab(tab, page);
		});
		tabs.addTab("Table", table(item, panels));
		return tabs;
	}

	private JPanel table(final Item item, final List<FigurePanel> panels) {
		final ResultsTable values = LivePlots.table(item.measurements);
		final JTable table = new JTable(model(values));
		table.setName("table");
		table.setAutoResizeMode(JTable.AUTO_RESIZE_OFF);
		GuiFont.scale(table);
		GuiFont.scale(table.getTableHeader());
		table.setRowHeight(table.getFontMetrics(table.getFont()).getHeight() + 2);
		table.getSelectionModel().addListSelectionListener(e -> {
			if (!e.getValueIsAdjusting() && table.getSelectedRow() >= 0)
				goTo(item.filament, table.getSelectedRow() + 1, panels);
		});
		final JButton open = new JButton("In ImageJ");
		open.setToolTipText("As ImageJ's table, to sort, plot and save");
		open.addActionListener(e -> showTable(item, movie));
		final JPanel buttons = new JPanel(new FlowLayout(FlowLayout.RIGHT, 4, 0));
		buttons.add(open);
		final JPanel page = new JPanel(new BorderLayout(4, 4));
		page.add(new JScrollPane(table), BorderLayout.CENTER);
		page.add(buttons, BorderLayout.SOUTH);
		return page;
	}

	private static DefaultTableModel model(final ResultsTable values) {
		final String[] headings = values.getHeadings();
		final Object[][] cells = new Object[values.size()][headings.length];
		for (int row = 0; row < cells.length; row++)
			for (int c = 0; c < headings.length; c++)
				cells[row][c] = values.getStringValue(headings[c], row);
		return new DefaultTableModel(cells, headings) {

			private static final long serialVersionUID = 1L;

			@Override
			public boolean isCellEditable(final int row, final int column) {
				return false;
			}
		};
	}

	/**
	 * Shows ImageJ's table {@code <name>-measurements}, whose rows lead to the frames.
	 *
	 * @param item what was measured
	 * @param movie finds the movie's image, if it is open
	 */
	public static void showTable(final Item item, final Supplier<Optional<ImagePlus>> movie) {
		final String title = item.measurements.name() + "-measurements";
		LivePlots.table(item.measurements).show(title);
		TableClicks.lead(title, movie, item.filament);
	}

	private void goTo(final int filament, final int frame, final List<FigurePanel> panels) {
		panels.forEach(p -> p.mark(frame));
		status.setText(
			movie.get().filter(image -> ShownFrame.goTo(image, filament, frame)).isPresent()
				? "Frame " + frame + " is shown in the movie."
				: "Frame " + frame + ": open the movie to see it.");
	}
}
