package io.github.knotresolver.command;

import java.awt.Container;
import java.awt.Dialog;
import java.awt.EventQueue;
import java.awt.Frame;
import java.awt.Rectangle;
import java.awt.event.KeyEvent;
import java.awt.event.WindowEvent;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;

import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JSpinner;

import ij.IJ;
import ij.ImagePlus;
import ij.Prefs;
import ij.io.FileSaver;
import io.github.knotresolver.imagej.ImageFile;
import io.github.knotresolver.imagej.SampleMovie;

/** What holds of several windows: help everywhere, ImageJ's scale, reviews that are opened and left. */
final class WindowScenes {

	private static final String RESOLVE = "Resolve Filament...", REVIEW = "Review Result...",
		CORRECT = "Correct Frame...", TUNE = "Tune Segmentation...";

	private final Path home;
	private final Hand hand;

	private WindowScenes(final Path home) throws Exception {
		this.home = home;
		hand = new Hand(20);
	}

	/** Robots need a display; names do not. */
	static Map<String, DialogsMain.Scene> scenes(final Path home) {
		return new TreeMap<>(
			Map.of("every field and button has its help", () -> new WindowScenes(home).help(),
				"windows have the scale of ImageJ", () -> new WindowScenes(home).scale(),
				"a review is of the image in front", () -> new WindowScenes(home).inFront(),
				"a review is left without saving, or not", () -> new WindowScenes(home).left(),
				"tuned values are saved to a sheet", () -> new WindowScenes(home).sheet()));
	}

	private void help() throws Exception {
		final ImagePlus image = DialogsMain.sample("helped");
		for (final String command : List.of(RESOLVE, TUNE, REVIEW, CORRECT, "Measure Contours...",
			"Batch...", "Simulate Movie...", "Evaluate Against Ground Truth...")) {
			Windows.start(command);
			final Dialog dialog = Windows.dialog(command);
			helped(dialog);
			Windows.press(dialog, "Cancel");
			Windows.await("end", () -> !dialog.isShowing());
		}
		Windows.start(TUNE);
		Windows.press(Windows.dialog(TUNE), "OK");
		final Frame tune = Windows.frame("Tune helped");
		helped(tune);
		close(tune);
		resolve(image);
		final Frame review = review(image);
		helped(review);
		close(review);
	}

	private static void helped(final Container window) {
		final List<String> without = Windows.withoutHelp(window);
		DialogsMain.require(without.isEmpty(), window.getName() + ": no help of " + without);
	}

	private void scale() throws Exception {
		final ImagePlus image = DialogsMain.sample("scaled");
		final float usual = new JLabel().getFont().getSize2D();
		Prefs.setGuiScale(2);
		try {
			Windows.start(RESOLVE);
			final Dialog dialog = Windows.dialog(RESOLVE);
			large(dialog, usual);
			Windows.type(dialog, "Frames", "1-3");
			Windows.press(dialog, "OK");
			DialogsMain.finished();
			final Frame outcome = Windows.frame("Resolved scaled");
			large(outcome, usual);
			final Frame review = review(image);
			large(review, usual);
			close(review);
		} finally {
			Prefs.setGuiScale(1);
		}
	}

	/** Once, not twice. */
	private static void large(final Container window, final float usual) {
		for (final JComponent part : Windows.all(window, JLabel.class))
			DialogsMain.require(Math.abs(part.getFont().getSize2D() - 2 * usual) < 0.1,
				((JLabel) part).getText() + " has a font of " + part.getFont().getSize2D());
		final Rectangle screen = window.getGraphicsConfiguration().getBounds();
		DialogsMain.require(screen.contains(window.getBounds()),
			window.getBounds() + " on " + screen);
	}

	private void inFront() throws Exception {
		for (final String command : List.of(REVIEW, CORRECT))
			refused(command);
		final ImagePlus resolved = DialogsMain.sample("resolved");
		resolve(resolved);
		final ImagePlus other = DialogsMain.sample("another");
		refused(REVIEW);
		IJ.selectWindow(resolved.getID());
		resolved.setSlice(2);
		Windows.start(CORRECT);
		Windows.press(Windows.dialog(CORRECT), "OK");
		final Frame review = Windows.frame("Review resolved");
		Windows.await("frame 2", () -> Windows.text(review).contains("frame 2 "));
		DialogsMain.require(other.getOverlay() == null, "The other image is drawn on.");
		close(review);
	}

	private static void refused(final String command) throws Exception {
		Windows.start(command);
		Windows.press(Windows.dialog(command), "OK");
		Windows.message("the active image has no result in memory");
	}

	/** With the keyboard: a contour is refused, and while that is worked out the window is closed. */
	private void left() throws Exception {
		final ImagePlus image = DialogsMain.sample("left");
		resolve(image);
		final int shapes = image.getOverlay().size(),
			listeners = image.getCanvas().getMouseListeners().length;
		final Frame review = review(image);
		hand.focus(review, review);
		hand.key(KeyEvent.VK_X);
		Windows.await("said", () -> Windows.text(review).contains("not saved yet")
			|| Windows.text(review).contains("..."));
		leave(review);
		Windows.press(Windows.dialog("Review", "Save the corrections of left?"), "Cancel");
		Windows.await("question to go", () -> Windows.dialogs().findAny().isEmpty());
		DialogsMain.require(review.isShowing(), "It is closed.");
		leave(review);
		Windows.press(Windows.dialog("Review", "Save the corrections of left?"), "No");
		Windows.await("end", () -> !review.isShowing());
		DialogsMain.require(
			image.getOverlay().size() == shapes
				&& image.getCanvas().getMouseListeners().length == listeners && !image.isLocked(),
			"The image is not as before.");
		Windows.await("end of the work", () -> Thread.getAllStackTraces().keySet().stream()
			.noneMatch(t -> t.getName().startsWith("KnotResolver")));
	}

	private void sheet() throws Exception {
		final ImagePlus sample = SampleMovie.open();
		final Path movie = home.resolve("tuned.tif");
		new FileSaver(sample).saveAsTiff(movie.toString());
		final ImagePlus image = ImageFile.open(movie);
		image.show();
		Windows.start(TUNE);
		Windows.press(Windows.dialog(TUNE), "OK");
		final Frame window = Windows.frame("Tune tuned.tif");
		Windows.onEvents(() -> ((JSpinner) Windows.find(window, "threshold")).setValue(0.45));
		hand.clickUntil("the file's name", Windows.find(window, "Save to sheet..."),
			() -> Windows.dialogs().findAny().isPresent());
		Windows.press(Windows.dialog("Batch sheet (CSV), new or present"), "Write the row");
		Windows.await("words", () -> Windows.text(window).contains("Written: the row of"));
		final String row = Files.readString(home.resolve("sheet.csv"));
		DialogsMain.require(row.contains("tuned.tif") && row.contains("0.45"), row);
		close(window);
		image.close();
		Files.delete(home.resolve("sheet.csv"));
		Files.delete(movie);
	}

	private static void resolve(final ImagePlus image) {
		IJ.run(image, RESOLVE, "frames=1-3 tables=false roi_manager=false");
	}

	private static Frame review(final ImagePlus image) throws Exception {
		Windows.start(REVIEW);
		Windows.press(Windows.dialog(REVIEW), "OK");
		final Frame review = Windows.frame("Review " + image.getTitle());
		Windows.await("words", () -> Windows.text(review).contains("frame 1 "));
		return review;
	}

	private static void leave(final Frame window) {
		EventQueue.invokeLater(
			() -> window.dispatchEvent(new WindowEvent(window, WindowEvent.WINDOW_CLOSING)));
	}

	private static void close(final Frame window) throws Exception {
		leave(window);
		Windows.await("end of " + window.getTitle(), () -> !window.isShowing());
	}
}
