package io.github.knotresolver.command;

import java.awt.Button;
import java.awt.Component;
import java.awt.Container;
import java.awt.Dialog;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.Robot;
import java.awt.TextField;
import java.awt.Window;
import java.awt.event.ActionEvent;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.io.File;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.Callable;

import javax.imageio.ImageIO;

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

	private static final long PATIENCE_MILLIS = 60_000;
	private static final String RESOLVE = "Resolve Filament...";

	private final File folder;
	private final Robot robot;

	private ScreenshotsMain(final File folder) throws Exception {
		this.folder = folder;
		robot = new Robot();
		robot.setAutoDelay(40);
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
			dialog(command,
				command.split("[ .]")[0].toLowerCase(java.util.Locale.ROOT) + "-dialog.png",
				"Cancel");
		measure();
	}

	private void menu(final ImageJ imagej) throws Exception {
		await("ImageJ", imagej::isShowing);
		pause();
		final Point at = imagej.getLocationOnScreen();
		click(at.x + 320, at.y + imagej.getInsets().top - 12);
		pause();
		for (final int key : new int[]{KeyEvent.VK_UP, KeyEvent.VK_RIGHT, KeyEvent.VK_RIGHT}) {
			robot.keyPress(key);
			robot.keyRelease(key);
			pause();
		}
		capture("menu.png", new Rectangle(0, 0, 700, 260));
		for (int i = 0; i < 4; i++) {
			robot.keyPress(KeyEvent.VK_ESCAPE);
			robot.keyRelease(KeyEvent.VK_ESCAPE);
		}
	}

	private void noImage() throws Exception {
		start(RESOLVE);
		press(dialog(RESOLVE), "  OK  ");
		expectMessage("There is no image open");
	}

	private void wrongValue() throws Exception {
		start(RESOLVE);
		final Dialog dialog = dialog(RESOLVE);
		fields(dialog).stream().filter(f -> f.getText().equals("otsu")).findFirst().orElseThrow()
			.setText("1.5");
		press(dialog, "  OK  ");
		expectMessage("threshold must be a number from 0 to 1");
	}

	private void escape(final ImagePlus image) throws Exception {
		start(RESOLVE);
		press(dialog(RESOLVE), "  OK  ");
		pause();
		image.getWindow().toFront();
		image.getCanvas().requestFocus();
		robot.keyPress(KeyEvent.VK_ESCAPE);
		robot.keyRelease(KeyEvent.VK_ESCAPE);
		expectMessage("Cancelled");
		if (image.getOverlay() != null)
			throw new IllegalStateException("Cancelled, but there is an overlay.");
	}

	private String resolve(final ImagePlus image) throws Exception {
		start(RESOLVE);
		press(dialog(RESOLVE), "  OK  ");
		await("overlay", () -> image.getOverlay() != null);
		await("tables", () -> WindowManager.getWindow(image.getTitle() + "-frames") != null);
		Thread.sleep(1500);
		WindowManager.getWindow(image.getTitle() + "-contours").setLocation(620, 560);
		WindowManager.getWindow(image.getTitle() + "-frames").setLocation(620, 280);
		RoiManager.getRoiManager().setLocation(1100, 20);
		WindowManager.getWindow("Log").setLocation(20, 700);
		WindowManager.getWindow("Log").setSize(580, 180);
		Recorder.getInstance().setLocation(20, 520);
		Recorder.getInstance().setSize(580, 150);
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

	private void measure() throws Exception {
		start("Measure Contours...");
		press(dialog("Measure Contours..."), "  OK  ");
		await("plots", () -> WindowManager.getImageCount() >= 6);
		Thread.sleep(1500);
		capture("measurements.png", new Rectangle(0, 0, 1440, 1000));
	}

	private void dialog(final String command, final String picture, final String button)
		throws Exception {
		start(command);
		final Dialog dialog = dialog(command);
		pause();
		capture(picture, dialog.getBounds());
		press(dialog, button);
		pause();
	}

	/** As the menu does it: in a thread of its own, without options. */
	private static void start(final String command) {
		IJ.doCommand(command);
	}

	private static Dialog dialog(final String title) throws Exception {
		final List<Dialog> found = new ArrayList<>();
		await("dialog " + title, () -> {
			found.clear();
			for (final Window window : Window.getWindows())
				if (window instanceof Dialog d && d.isShowing() && title.equals(d.getTitle()))
					found.add(d);
			return !found.isEmpty();
		});
		return found.get(0);
	}

	private void expectMessage(final String sentence) throws Exception {
		final List<Dialog> found = new ArrayList<>();
		await("message '" + sentence + "'", () -> {
			for (final Window window : Window.getWindows())
				if (window instanceof Dialog d && d.isShowing() && text(d).contains(sentence))
					found.add(d);
			return !found.isEmpty();
		});
		pause();
		System.out.println("Message: " + text(found.get(0)).strip());
		found.get(0).dispose();
		for (final Window window : Window.getWindows())
			if (window instanceof Dialog d && d.isShowing())
				press(d, "Cancel");
		// The command ends, and is recorded, after its message is gone.
		pause();
	}

	private static String text(final Container container) {
		final StringBuilder text = new StringBuilder();
		for (final Component c : container.getComponents())
			if (c instanceof java.awt.Label label)
				text.append(label.getText()).append(' ');
			else if (c instanceof ij.gui.MultiLineLabel label)
				text.append(lines(label)).append(' ');
			else if (c instanceof Container inner)
				text.append(text(inner));
		return text.toString();
	}

	private static String lines(final ij.gui.MultiLineLabel label) {
		try {
			final var lines = label.getClass().getDeclaredField("lines");
			lines.setAccessible(true);
			return String.join(" ", (String[]) lines.get(label));
		} catch (final ReflectiveOperationException e) {
			throw new IllegalStateException(e);
		}
	}

	private static List<TextField> fields(final Container container) {
		final List<TextField> fields = new ArrayList<>();
		for (final Component c : container.getComponents())
			if (c instanceof TextField field)
				fields.add(field);
			else if (c instanceof Container inner)
				fields.addAll(fields(inner));
		return fields;
	}

	private static void press(final Container container, final String label) {
		for (final Component c : container.getComponents())
			if (c instanceof Button button && button.getLabel().strip().equals(label.strip())) {
				final ActionEvent event = new ActionEvent(button, ActionEvent.ACTION_PERFORMED,
					label);
				for (final var listener : button.getActionListeners())
					listener.actionPerformed(event);
			} else if (c instanceof Container inner)
				press(inner, label);
	}

	private void click(final int x, final int y) {
		robot.mouseMove(x, y);
		robot.mousePress(InputEvent.BUTTON1_DOWN_MASK);
		robot.mouseRelease(InputEvent.BUTTON1_DOWN_MASK);
	}

	private void pause() throws InterruptedException {
		Thread.sleep(700);
	}

	private void capture(final String name, final Rectangle part) throws IOException {
		ImageIO.write(robot.createScreenCapture(part), "png", new File(folder, name));
	}

	private static void await(final String what, final Callable<Boolean> condition)
		throws Exception {
		final long end = System.currentTimeMillis() + PATIENCE_MILLIS;
		while (!condition.call()) {
			if (System.currentTimeMillis() > end)
				throw new IllegalStateException("Waited in vain for " + what + ".");
			Thread.sleep(50);
		}
	}
}
