package io.github.knotresolver.command;

import java.awt.Component;
import java.awt.Dialog;
import java.awt.Frame;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.awt.event.WindowEvent;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;

import javax.swing.JButton;
import javax.swing.JFrame;
import javax.swing.JLabel;
import javax.swing.JTextArea;

import ij.IJ;
import ij.ImageJ;
import ij.ImagePlus;
import ij.WindowManager;
import ij.gui.ImageCanvas;
import ij.plugin.frame.Recorder;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.io.ContourInput;

/**
 * A review in plain ImageJ on a display, with mouse and keys. Arguments: a result folder with a
 * correction that leaves frame 7 unresolved, and a folder for what is made here. Prints what was
 * reached, line by line, for {@link ReviewWindowTest}.
 */
final class ReviewMain {

	static final List<String> STEPS = List.of("opened", "click", "doubtful", "withdrawn",
		"mended in three clicks", "chosen", "undone", "dragged", "tip", "saved", "recorded",
		"closed", "image closed");

	/** The frame that the correction spoils. */
	static final int SPOILED = 7;

	private static final String REVIEW = "Review Result...";

	private final Path result, home;
	private final Hand hand;
	private JFrame window;
	private ImagePlus image;

	private ReviewMain(final Path result, final Path home) throws Exception {
		this.result = result;
		this.home = home;
		hand = new Hand(20);
	}

	public static void main(final String[] args) throws Exception {
		new ImageJ();
		IJ.run("Record...");
		try {
			new ReviewMain(Path.of(args[0]), Path.of(args[1])).play();
		} catch (final Exception | AssertionError e) {
			e.printStackTrace(System.out);
		}
		System.exit(0);
	}

	private void play() throws Exception {
		open();
		final int listeners = image.getCanvas().getMouseListeners().length;
		reached("opened");
		picture("review-small.png");
		hand.until("frame", () -> hand.click(find("confidence"), 0.52, 0.5),
			() -> text().startsWith("frame 13 "));
		require(image.getCurrentSlice() == 13, "slice " + image.getCurrentSlice());
		IJ.run(image, "Next Slice [>]", "");
		Windows.await("frame of the slider", () -> text().startsWith("frame 14 "));
		reached("click");
		mend();
		handle();
		save();
		close();
		require(image.getOverlay() == null, "The overlay stays.");
		require(image.getCanvas().getMouseListeners().length == listeners, "listeners");
		require(Arrays.asList(image.getCanvas().getMouseListeners()).contains(image.getCanvas()),
			"ImageJ does not hear the mouse any more.");
		reached("closed");
		open();
		image.close();
		Windows.await("end", () -> !window.isShowing());
		reached("image closed");
	}

	private void open() throws Exception {
		Windows.start(REVIEW);
		final Dialog dialog = Windows.dialog(REVIEW, "Result");
		Windows.type(dialog, "Result", result.toString());
		Windows.press(dialog, "OK");
		window = (JFrame) Windows.frame("Review " + result.getFileName());
		try {
			Windows.await("result",
				() -> label("headline").contains(" right, ") && label("status").isBlank());
		} catch (final AssertionError e) {
			throw new AssertionError(label("headline") + "; " + label("status"), e);
		}
		image = WindowManager.getCurrentImage();
		Windows.await("contour", () -> image.getOverlay() != null && image.getOverlay().size() > 0);
	}

	/** The doubtful frame comes with one click, is right after one more, and kept after a third. */
	private void mend() throws Exception {
		press("Next doubtful");
		Windows.await("doubtful", () -> text().startsWith("frame " + SPOILED + " "));
		require(text().contains("unresolved") && text().contains("draw the whole contour"), text());
		require(image.getOverlay() == null || image.getOverlay().size() == 0,
			"A contour is shown.");
		reached("doubtful");
		press("Withdraw");
		Windows.await("resolved", () -> text().contains("  resolved"));
		rest();
		reached("withdrawn");
		press("Save");
		Windows.await("saved", () -> label("status").startsWith("Saved in"));
		Files.copy(result.resolve("contours.csv"), home.resolve("mended.csv"));
		reached("mended in three clicks");
		key(KeyEvent.VK_N);
		key(KeyEvent.VK_SPACE);
		window.setBounds(0, 1000 - window.getHeight() * 5 / 4, window.getWidth() * 3 / 2,
			window.getHeight() * 5 / 4);
		rest();
		while (find("alternative 2") == null)
			key(KeyEvent.VK_RIGHT);
		final String before = text();
		key(KeyEvent.VK_2);
		Windows.await("chosen", () -> text().contains("corrected"));
		rest();
		picture("review-large.png");
		reached("chosen");
		press("Undo");
		Windows.await("undone", () -> text().equals(before));
		rest();
		reached("undone");
	}

	/** The contour and its end are drawn elsewhere by the mouse, by a pixel or two. */
	private void handle() throws Exception {
		final Polyline contour = ContourInput.read(result).contours().get(frame() - 1)
			.orElseThrow();
		drag(contour.at(contour.length() / 2), 2);
		Windows.await("dragged", () -> text().contains("corrected"));
		rest();
		require(text().contains("As the user said"), text());
		require(image.getRoi() == null, "ImageJ made a selection of the drag.");
		reached("dragged");
		// The mouse was in the image, and so are the keys.
		final int dragged = frame();
		key(image.getWindow(), image.getCanvas(), KeyEvent.VK_RIGHT);
		Windows.await("next", () -> text().startsWith("frame " + (dragged + 1) + " "));
		drag(ContourInput.read(result).contours().get(frame() - 1).orElseThrow().last(), 2);
		Windows.await("tip", () -> text().contains("corrected"));
		rest();
		reached("tip");
	}

	private int frame() {
		return image.getCurrentSlice();
	}

	private void save() throws Exception {
		key(KeyEvent.VK_S);
		Windows.await("saved", () -> label("status").startsWith("Saved in"));
		final String said = Files.readString(result.resolve("corrections.csv"));
		require(said.contains(",through,0,") && said.contains(",tip,0,"), said);
		reached("saved");
		final String start = "run(\"Resolve Filament...\", \"movie=";
		final String line = Recorder.getInstance().getText().lines()
			.filter(l -> l.startsWith(start)).reduce((first, last) -> last).orElseThrow();
		Files.writeString(home.resolve("recorded.ijm"), line);
		reached("recorded");
	}

	private void close() throws Exception {
		window.dispatchEvent(new WindowEvent(window, WindowEvent.WINDOW_CLOSING));
		Windows.await("end", () -> !window.isShowing());
	}

	private void rest() throws Exception {
		Windows.await("rest", () -> !label("status").endsWith("..."));
		hand.waitForIdle();
	}

	private void key(final int code) throws Exception {
		key(window, window, code);
	}

	private void key(final Frame frame, final Component inside, final int code) throws Exception {
		hand.focus(frame, inside);
		hand.key(code);
	}

	private void press(final String words) throws Exception {
		final Component button = Windows.all(window.getContentPane(), JButton.class).stream()
			.filter(b -> words.equals(b.getName())).findFirst().orElseThrow();
		hand.click(button, 0.5, 0.5);
	}

	private void drag(final io.github.knotresolver.geometry.Point from, final int pixels)
		throws Exception {
		final ImageCanvas canvas = image.getCanvas();
		hand.over(canvas, (canvas.screenXD(from.x() + 0.5) + 0.5) / canvas.getWidth(),
			(canvas.screenYD(from.y() + 0.5) + 0.5) / canvas.getHeight());
		final Point corner = canvas.getLocationOnScreen();
		final int x = corner.x + canvas.screenXD(from.x() + 0.5),
			y = corner.y + canvas.screenYD(from.y() + 0.5);
		final int far = (int) Math.max(5, pixels * canvas.getMagnification());
		hand.mousePress(InputEvent.BUTTON1_DOWN_MASK);
		hand.mouseMove(x + far / 2, y);
		hand.mouseMove(x + far, y);
		hand.mouseRelease(InputEvent.BUTTON1_DOWN_MASK);
		hand.waitForIdle();
	}

	private Component find(final String name) {
		return Windows.named(window.getContentPane(), name).orElse(null);
	}

	private String label(final String name) {
		return ((JLabel) Windows.named(window.getContentPane(), name).orElseThrow()).getText();
	}

	private String text() {
		return ((JTextArea) Windows.named(window.getContentPane(), "frame").orElseThrow())
			.getText();
	}

	/** What is on the screen. */
	private void picture(final String name) throws Exception {
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
