package io.github.knotresolver.command;

import java.awt.Component;
import java.awt.Frame;
import java.awt.Rectangle;
import java.awt.event.KeyEvent;
import java.awt.event.WindowEvent;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;

import javax.swing.JLabel;
import javax.swing.JTabbedPane;
import javax.swing.JTable;
import javax.swing.JTextArea;
import javax.swing.SwingUtilities;

import ij.IJ;
import ij.ImageJ;
import ij.ImagePlus;
import ij.WindowManager;
import ij.gui.PolygonRoi;
import ij.gui.Roi;
import ij.plugin.frame.RoiManager;
import ij.process.FloatPolygon;
import ij.text.TextWindow;
import io.github.knotresolver.imagej.ImageFile;

/**
 * From a run to its picture and back, in plain ImageJ on a display, with mouse and keys: tables,
 * measurements, the review of what is in memory, the ROI Manager, and a batch. Arguments: a folder with
 * {@code movie.tif} and a sheet {@code sheet.csv} of two rows, one of which asks for work by hand.
 * Prints what was reached, line by line, for {@link ResultWindowsTest}.
 */
final class ResultWindowsMain {

	static final List<String> STEPS = List.of("table row", "kymograph", "point over time",
		"measured row", "live review", "taken over", "live end", "batch table", "batch review",
		"batch in turn");

	private static final String MOVIE = "movie.tif";

	private final Path home;
	private final Hand hand;
	private ImagePlus image;

	private ResultWindowsMain(final Path home) throws Exception {
		this.home = home;
		hand = new Hand(30);
	}

	public static void main(final String[] args) throws Exception {
		new ImageJ();
		try {
			new ResultWindowsMain(Path.of(args[0])).play();
		} catch (final Exception | AssertionError e) {
			e.printStackTrace(System.out);
		}
		System.exit(0);
	}

	private void play() throws Exception {
		image = ImageFile.open(home.resolve(MOVIE));
		image.show();
		IJ.run("Resolve Filament...", "frames=1-8 plots=false");
		tables();
		measure();
		review();
		batch();
	}

	private void tables() throws Exception {
		final TextWindow table = (TextWindow) WindowManager.getFrame(MOVIE + "-frames");
		table.setBounds(500, 100, 600, 300);
		table.toFront();
		hand.waitForIdle();
		final Component canvas = table.getTextPanel().getComponent(0);
		// The heading is one row high, and so are the rows.
		hand.until("selected row",
			() -> hand.click(canvas, 60.0 / canvas.getWidth(), 90.0 / canvas.getHeight()),
			() -> table.getTextPanel().getSelectionStart() > 0);
		final int row = table.getTextPanel().getSelectionStart();
		Windows.await("frame of the row", () -> image.getCurrentSlice() == row + 1);
		require(image.getRoi() != null && image.getRoi().getType() == Roi.POLYLINE,
			"The contour is not selected.");
		reached("table row");
		for (final String title : List.of("-frames", "-contours", "-filaments"))
			((TextWindow) WindowManager.getFrame(MOVIE + title)).close(false);
	}

	private void measure() throws Exception {
		image.setSlice(1);
		image.deleteRoi();
		Windows.start("Measure Contours...");
		Windows.press(Windows.dialog("Measure Contours..."), "OK");
		final Frame window = Windows.frame("Measurements of " + MOVIE);
		final JTabbedPane tabs = (JTabbedPane) Windows.find(window, "tabs 1");
		require(tabs.getTabCount() >= 4, tabs.getTabCount() + " tabs");
		window.setLocation(500, 60);
		select(window, tabs, "Contours");
		picture("measure-contours.png");
		select(window, tabs, "Kymographs");
		picture("measure-kymographs.png");
		hand.until("frame of the kymograph",
			() -> clickAt(Windows.find(window, "figure tangent_angle_kymograph"), 0.4, 0.3),
			() -> image.getCurrentSlice() > 1);
		reached("kymograph");
		image.setSlice(1);
		select(window, tabs, "Length, ends");
		picture("measure-length.png");
		hand.until("frame of the point",
			() -> clickAt(Windows.find(window, "figure length"), 0.8, 0.3),
			() -> image.getCurrentSlice() > 4);
		reached("point over time");
		select(window, tabs, "Tip angle");
		window.setSize(window.getWidth() * 3 / 4, window.getHeight() * 3 / 4);
		picture("measure-small.png");
		select(window, tabs, "Table");
		clickAt(Windows.find(window, "table"), 0.1, 0.5);
		final int row = ((JTable) Windows.find(window, "table")).getSelectedRow();
		Windows.await("frame of the row", () -> image.getCurrentSlice() == row + 1);
		reached("measured row");
		window.dispose();
	}

	private void select(final Frame window, final JTabbedPane tabs, final String tab)
		throws Exception {
		SwingUtilities.invokeAndWait(() -> {
			window.toFront();
			tabs.setSelectedIndex(tabs.indexOfTab(tab));
		});
		hand.waitForIdle();
	}

	/** What was just found, without a folder; a contour is changed in the ROI Manager meanwhile. */
	private void review() throws Exception {
		Windows.start("Review Result...");
		Windows.press(Windows.dialog("Review Result...", "Result"), "OK");
		final Frame window = Windows.frame("Review " + MOVIE);
		Windows.await("ready", () -> words(window).startsWith("frame 1 "));
		reached("live review");
		final RoiManager manager = RoiManager.getInstance2();
		SwingUtilities.invokeAndWait(() -> {
			manager.select(2);
			final FloatPolygon line = image.getRoi().getFloatPolygon();
			for (int i = 0; i < line.npoints; i++)
				line.ypoints[i] += 3f * i / line.npoints;
			final Roi moved = new PolygonRoi(line, Roi.POLYLINE);
			moved.copyAttributes(image.getRoi());
			image.setRoi(moved);
			manager.runCommand("Update");
			window.toFront();
			window.requestFocus();
		});
		hand.waitForIdle();
		hand.key(KeyEvent.VK_M);
		Windows.await("taken over", () -> words(window).contains("corrected"));
		require(words(window).startsWith("frame 3 "), words(window));
		picture("live-review.png");
		reached("taken over");
		hand.key(KeyEvent.VK_Z, KeyEvent.VK_CONTROL);
		Windows.await("undone", () -> words(window).contains("  resolved"));
		close(window);
		require(image.getWindow() != null, "The image is closed.");
		reached("live end");
	}

	private void batch() throws Exception {
		image.changes = false;
		image.close();
		final Path out = home.resolve("batch");
		Windows.start("Batch...");
		final var dialog = Windows.dialog("Batch...", "Input");
		Windows.type(dialog, "Input", home.resolve("sheet.csv").toString());
		Windows.type(dialog, "Out", out.toString());
		Windows.type(dialog, "Options", "frames=1-5");
		Windows.press(dialog, "OK");
		final Frame window = Windows.frame("Batch batch");
		final JTable table = (JTable) Windows.find(window, "outcomes");
		require(table.getRowCount() == 2 && table.getValueAt(0, 1).equals("finished")
			&& table.getValueAt(1, 2).equals("asked for"), table.getValueAt(0, 1).toString());
		picture("batch.png");
		reached("batch table");
		final Rectangle cell = table.getCellRect(0, 0, true);
		final String first = reviewed(out, table.getModel().getValueAt(0, 0).toString());
		hand.until(first,
			() -> hand.doubleClick(table, (cell.x + 20.0) / table.getWidth(),
				(cell.y + 8.0) / table.getHeight()),
			() -> Windows.shown(first::equals).isPresent());
		close(Windows.frame(first));
		reached("batch review");
		final String second = reviewed(out, table.getModel().getValueAt(1, 0).toString());
		hand.clickUntil(second, Windows.find(window, "Review in turn"),
			() -> Windows.shown(second::equals).isPresent());
		close(Windows.frame(second));
		Windows.await("the end", () -> ((JLabel) Windows.find(window, "status")).getText()
			.startsWith("All have been reviewed."));
		reached("batch in turn");
	}

	/** Title of the review of a result, whose folder is named after the movie. */
	private static String reviewed(final Path out, final String movie) throws Exception {
		final String stem = movie.substring(0, movie.lastIndexOf('.'));
		final Path folder;
		try (var all = Files.list(out)) {
			folder = all.filter(p -> p.getFileName().toString().startsWith(stem)).findFirst()
				.orElseThrow();
		}
		return "Review " + folder.getFileName();
	}

	private static void close(final Frame window) throws Exception {
		window.dispatchEvent(new WindowEvent(window, WindowEvent.WINDOW_CLOSING));
		Windows.await("end of " + window.getTitle(), () -> !window.isShowing());
	}

	private static String words(final Frame window) {
		return ((JTextArea) Windows.find(window, "frame")).getText();
	}

	private void clickAt(final Component component, final double across, final double down)
		throws Exception {
		final int height = component.getHeight();
		hand.click(component, across, down * Math.min(height, 300) / height);
	}

	/** What is on the screen. */
	private void picture(final String name) throws Exception {
		hand.waitForIdle();
		hand.delay(300);
		hand.picture(new Rectangle(1440, 1000), home.resolve(name).toFile());
	}

	private static void reached(final String step) {
		System.out.println("reached: " + step);
	}

	private static void require(final boolean condition, final String otherwise) {
		if (!condition)
			throw new AssertionError(otherwise);
	}
}
