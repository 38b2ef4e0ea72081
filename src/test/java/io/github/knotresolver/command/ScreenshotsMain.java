package io.github.knotresolver.command;

import java.awt.Dialog;
import java.awt.Frame;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.Window;
import java.awt.event.KeyEvent;
import java.io.File;
import java.util.List;
import java.util.Locale;

import javax.swing.AbstractButton;
import javax.swing.JSpinner;

import ij.IJ;
import ij.ImageJ;
import ij.ImagePlus;
import ij.WindowManager;
import ij.plugin.frame.Recorder;
import ij.plugin.frame.RoiManager;

/**
 * Walks through plain ImageJ as a new user would, with mouse and keys, checks
 * what comes of it, and takes the pictures of {@code docs/fiji.md}. Started by
 * {@code scripts/make-screenshots}, which gives it a display.
 */
final class ScreenshotsMain {

	private static final String RESOLVE = "Resolve Filament...", TUNE = "Tune Segmentation...",
		OK = "OK", CANCEL = "Cancel";

	/** A frame of the sample in which the filament crosses itself. */
	private static final int KNOTTED = 13;
	private static final int STRIP_MILLIS = 8000;
	private static final double TUNED_THRESHOLD = 0.4, MAGNIFIED = 6;

	private final Hand hand = new Hand(40);
	private final Gallery gallery;

	private ScreenshotsMain(final File folder, final boolean inSizes) throws Exception {
		gallery = new Gallery(hand, folder, inSizes);
	}

	public static void main(final String[] args) throws Exception {
		final ImageJ imagej = new ImageJ();
		imagej.setLocation(20, 20);
		try {
			new ScreenshotsMain(new File(args[0]), args.length > 1).walk(imagej);
			System.out.println("All as expected.");
			System.exit(0);
		} catch (final Throwable e) {
			e.printStackTrace();
			System.exit(1);
		}
	}

	private void walk(final ImageJ imagej) throws Exception {
		menu(imagej);
		noImage();
		IJ.run("Knotted Filament");
		final ImagePlus image = WindowManager.getCurrentImage();
		image.getWindow().setLocation(20, 130);
		while (image.getCanvas().getMagnification() > MAGNIFIED)
			image.getCanvas().zoomOut(0, 0);
		preview(image);
		tune(image);
		IJ.run("Record...");
		wrongValue();
		escape(image);
		final String line = resolve(image);
		replay(image, line);
		for (final String command : List.of("Measure Contours...", "Batch...", "Simulate Movie...",
			"Evaluate Against Ground Truth..."))
			dialog(command, command.split("[ .]")[0].toLowerCase(Locale.ROOT) + "-dialog.png");
	}

	private void menu(final ImageJ imagej) throws Exception {
		Windows.await("ImageJ", imagej::isShowing);
		pause();
		final Point at = imagej.getLocationOnScreen();
		hand.click(at.x + 320, at.y + imagej.getInsets().top - 12);
		pause();
		for (final int key : new int[]{KeyEvent.VK_UP, KeyEvent.VK_RIGHT, KeyEvent.VK_RIGHT}) {
			hand.key(key);
			pause();
		}
		gallery.take("menu.png", new Rectangle(0, 0, 930, 420));
		for (int i = 0; i < 4; i++)
			hand.key(KeyEvent.VK_ESCAPE);
	}

	private void noImage() throws Exception {
		Windows.start(RESOLVE);
		Windows.press(Windows.dialog(RESOLVE), OK);
		expect("There is no image open");
	}

	private void preview(final ImagePlus image) throws Exception {
		image.setSlice(KNOTTED);
		Windows.start(RESOLVE);
		final Dialog dialog = Windows.dialog(RESOLVE, "frame " + KNOTTED + ": 1 filament");
		dialog.setLocation(image.getWindow().getX() + image.getWindow().getWidth() + 10,
			image.getWindow().getY());
		Windows.await("overlay", () -> image.getOverlay() != null);
		front(dialog);
		gallery.take("resolve-dialog.png", dialog.getBounds().union(image.getWindow().getBounds()),
			dialog);
		Windows.onEvents(((AbstractButton) Windows.find(dialog, "Advanced"))::doClick);
		Windows.await("advanced", () -> Windows.find(dialog, "threshold").isShowing());
		front(dialog);
		gallery.take("resolve-advanced.png", dialog.getBounds(), dialog);
		Windows.press(dialog, CANCEL);
		Windows.await("end", () -> !dialog.isShowing() && image.getOverlay() == null);
	}

	private void tune(final ImagePlus image) throws Exception {
		Windows.start(TUNE);
		Windows.press(Windows.dialog(TUNE), OK);
		final Frame window = Windows.frame("Tune " + image.getTitle());
		window.setLocation(image.getWindow().getX(),
			image.getWindow().getY() + image.getWindow().getHeight() + 10);
		Windows.await("mask", () -> image.getOverlay() != null);
		Windows.onEvents(
			() -> ((JSpinner) Windows.find(window, "threshold")).setValue(TUNED_THRESHOLD));
		Windows.await("words", () -> Windows.text(window).contains("frame " + KNOTTED + ": ")
			&& image.getOverlay() != null);
		front(window);
		// The strip fills from the present frame outwards.
		Thread.sleep(STRIP_MILLIS);
		gallery.take("tune.png", window.getBounds().union(image.getWindow().getBounds()), window);
		Windows.press(window, "Close");
		Windows.await("end", () -> !window.isShowing() && image.getOverlay() == null);
	}

	private void wrongValue() throws Exception {
		Windows.start(RESOLVE);
		final Dialog dialog = Windows.dialog(RESOLVE);
		Windows.type(dialog, "Threshold", "1.5");
		Windows.press(dialog, OK);
		Windows.dialog(RESOLVE, "threshold must be a number from 0 to 1");
		Windows.press(dialog, CANCEL);
		Windows.await("end", () -> !dialog.isShowing());
	}

	private void escape(final ImagePlus image) throws Exception {
		Windows.start(RESOLVE);
		Windows.press(Windows.dialog(RESOLVE), OK);
		pause();
		image.getWindow().toFront();
		image.getCanvas().requestFocus();
		hand.key(KeyEvent.VK_ESCAPE);
		expect("Cancelled");
		if (image.getOverlay() != null)
			throw new IllegalStateException("Cancelled, but there is an overlay.");
	}

	private String resolve(final ImagePlus image) throws Exception {
		Windows.start(RESOLVE);
		Windows.press(Windows.dialog(RESOLVE), OK);
		Windows.await("overlay", () -> image.getOverlay() != null);
		Windows.await("tables",
			() -> WindowManager.getWindow(image.getTitle() + "-frames") != null);
		Thread.sleep(1500);
		place(image.getTitle() + "-filaments", 850, 20, 580, 110);
		place(image.getTitle() + "-frames", 850, 150, 580, 300);
		place(image.getTitle() + "-contours", 850, 470, 580, 500);
		place("Log", 20, 650, 570, 150);
		place("Recorder", 20, 820, 570, 150);
		place("ROI Manager", 605, 650, 230, 220);
		Windows.frame("Resolved " + image.getTitle()).setLocation(110, 530);
		Thread.sleep(1000);
		gallery.take("result.png", new Rectangle(0, 0, 1440, 1000));
		if (RoiManager.getRoiManager().getCount() == 0)
			throw new IllegalStateException("There is no ROI.");
		final String recorded = Recorder.getInstance().getText();
		System.out.println(recorded);
		final int at = recorded.lastIndexOf("run(\"" + RESOLVE);
		return recorded.substring(at, recorded.indexOf('\n', at));
	}

	private void replay(final ImagePlus image, final String line) throws Exception {
		final int rois = RoiManager.getRoiManager().getCount();
		image.setOverlay(null);
		IJ.runMacro(line);
		if (image.getOverlay() == null || RoiManager.getRoiManager().getCount() != rois)
			throw new IllegalStateException("The recorded line does not do the same: " + line);
	}

	private static void place(final String title, final int x, final int y, final int width,
		final int height) {
		WindowManager.getWindow(title).setBounds(x, y, width, height);
	}

	private void dialog(final String command, final String picture) throws Exception {
		Windows.start(command);
		final Dialog dialog = Windows.dialog(command);
		front(dialog);
		gallery.take(picture, dialog.getBounds(), dialog);
		Windows.press(dialog, CANCEL);
		Windows.await("end", () -> !dialog.isShowing());
	}

	private static void expect(final String sentence) throws Exception {
		System.out.println("Message: " + Windows.message(sentence));
	}

	private void front(final Window window) throws Exception {
		Windows.onEvents(window::toFront);
		pause();
	}

	private void pause() throws InterruptedException {
		Thread.sleep(700);
	}
}
