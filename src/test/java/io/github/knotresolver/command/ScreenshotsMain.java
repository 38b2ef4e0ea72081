package io.github.knotresolver.command;

import java.awt.Dialog;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.event.KeyEvent;
import java.io.File;
import java.io.IOException;
import java.util.List;
import java.util.Locale;

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

	private static final String RESOLVE = "Resolve Filament...";

	private final File folder;
	private final Hand hand;

	private ScreenshotsMain(final File folder) throws Exception {
		this.folder = folder;
		hand = new Hand(40);
	}

	public static void main(final String[] args) throws Exception {
		final ImageJ imagej = new ImageJ();
		imagej.setLocation(20, 20);
		try {
			new ScreenshotsMain(new File(args[0])).walk(imagej);
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
		image.getWindow().setLocation(20, 160);
		for (int i = 0; i < 5; i++)
			image.getCanvas().zoomIn(0, 0);
		IJ.run("Record...");
		dialog(RESOLVE, "resolve-dialog.png", "Cancel");
		wrongValue();
		escape(image);
		final String line = resolve(image);
		replay(image, line);
		for (final String command : List.of("Measure Contours...", "Batch...", "Simulate Movie...",
			"Evaluate Against Ground Truth..."))
			dialog(command, command.split("[ .]")[0].toLowerCase(Locale.ROOT) + "-dialog.png",
				"Cancel");
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
		capture("menu.png", new Rectangle(0, 0, 930, 320));
		for (int i = 0; i < 4; i++)
			hand.key(KeyEvent.VK_ESCAPE);
	}

	private void noImage() throws Exception {
		Windows.start(RESOLVE);
		Windows.press(Windows.dialog(RESOLVE), "  OK  ");
		expect("There is no image open");
	}

	private void wrongValue() throws Exception {
		Windows.start(RESOLVE);
		final Dialog dialog = Windows.dialog(RESOLVE);
		Windows.type(dialog, "Threshold", "1.5");
		Windows.press(dialog, "  OK  ");
		expect("threshold must be a number from 0 to 1");
	}

	private void escape(final ImagePlus image) throws Exception {
		Windows.start(RESOLVE);
		Windows.press(Windows.dialog(RESOLVE), "  OK  ");
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
		Windows.press(Windows.dialog(RESOLVE), "  OK  ");
		Windows.await("overlay", () -> image.getOverlay() != null);
		Windows.await("tables",
			() -> WindowManager.getWindow(image.getTitle() + "-frames") != null);
		Thread.sleep(1500);
		place(image.getTitle() + "-contours", 620, 560, 700, 430);
		place(image.getTitle() + "-frames", 620, 285, 700, 270);
		place("ROI Manager", 1100, 20, 230, 260);
		place("Log", 20, 710, 580, 180);
		place("Recorder", 20, 555, 580, 150);
		Thread.sleep(1000);
		capture("result.png", new Rectangle(0, 0, 1440, 1000));
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

	private void dialog(final String command, final String picture, final String button)
		throws Exception {
		Windows.start(command);
		final Dialog dialog = Windows.dialog(command);
		pause();
		capture(picture, dialog.getBounds());
		Windows.press(dialog, button);
		pause();
	}

	private static void expect(final String sentence) throws Exception {
		System.out.println("Message: " + Windows.message(sentence));
	}

	private void pause() throws InterruptedException {
		Thread.sleep(700);
	}

	private void capture(final String name, final Rectangle part) throws IOException {
		hand.picture(part, new File(folder, name));
	}
}
