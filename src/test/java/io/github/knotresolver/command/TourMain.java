package io.github.knotresolver.command;

import java.awt.Color;
import java.awt.Component;
import java.awt.Frame;
import java.awt.Graphics2D;
import java.awt.MouseInfo;
import java.awt.Point;
import java.awt.Polygon;
import java.awt.Rectangle;
import java.awt.RenderingHints;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.awt.event.WindowEvent;
import java.awt.image.BufferedImage;
import java.io.File;
import java.nio.file.Files;
import java.nio.file.Path;

import javax.swing.JLabel;
import javax.swing.JTabbedPane;
import javax.swing.SwingUtilities;

import ij.IJ;
import ij.ImageJ;
import ij.ImagePlus;
import ij.gui.ImageCanvas;
import ij.gui.Toolbar;
import ij.io.FileSaver;
import ij.process.ImageProcessor;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.imagej.SampleMovie;
import io.github.knotresolver.io.ContourInput;

/**
 * Walks through review, measurements and batch as a user would, with mouse and keys, and takes the
 * pictures and the film of {@code docs/fiji.md}. Arguments: the folder of the pictures, and one for
 * movies and results; and {@code sizes} for pictures of windows in other sizes, too. Started by
 * {@code scripts/make-tour}, which gives it a display.
 */
final class TourMain {

	/** The sample with so much noise (grey values) has frames that are in doubt. */
	private static final double NOISE = 34;
	private static final int SEED = 5;
	private static final String CLOSE_LOG = "\\Close";
	private static final double FILM_SCALE = 0.5;

	private final Path home;
	private final Hand hand;
	private final Gallery gallery;
	private final FilmGif film;
	private Frame window;
	private ImagePlus image;

	private TourMain(final Gallery gallery, final Hand hand, final Path home) throws Exception {
		this.gallery = gallery;
		this.hand = hand;
		this.home = home;
		film = new FilmGif(gallery.file("review.gif").toPath());
	}

	public static void main(final String[] args) throws Exception {
		final ImageJ imagej = new ImageJ();
		imagej.setLocation(10, 1080);
		try {
			final Hand hand = new Hand(40);
			new TourMain(new Gallery(hand, new File(args[0]), args.length > 2), hand,
				Path.of(args[1])).walk();
			System.out.println("All as expected.");
			System.exit(0);
		} catch (final Throwable e) {
			e.printStackTrace();
			System.exit(1);
		}
	}

	private void walk() throws Exception {
		final ImagePlus sample = SampleMovie.open();
		new FileSaver(sample).saveAsTiff(home.resolve("clear.tif").toString());
		ImageProcessor.setRandomSeed(SEED);
		for (int t = 1; t <= sample.getStackSize(); t++)
			sample.getStack().getProcessor(t).noise(NOISE);
		new FileSaver(sample).saveAsTiff(home.resolve("noisy.tif").toString());
		review();
		measure();
		batch();
	}

	private void review() throws Exception {
		final Path result = home.resolve("noisy-result");
		IJ.run("Resolve Filament...", "movie=[" + home.resolve("noisy.tif") + "] out=[" + result
			+ "] roi_manager=false tables=false plots=false");
		image = IJ.getImage();
		image.getWindow().setLocation(10, 10);
		Windows.start("Review Result...");
		Windows.press(Windows.dialog("Review Result...", "Result"), "OK");
		window = Windows.frame("Review noisy-result");
		IJ.log(CLOSE_LOG);
		window.setLocation(10, image.getWindow().getHeight() + 20);
		Windows.await("ready",
			() -> find("headline") instanceof JLabel l && l.getText().contains(" right, "));
		IJ.setTool(Toolbar.HAND);
		shot(8);
		press("Next doubtful");
		shot(10);
		gallery.take("review.png", both(), window);
		while (Windows.named(window, "alternative 2").isEmpty())
			hand.key(KeyEvent.VK_N);
		move(find("alternative 2"), 0.5, 0.5);
		hand.delay(300);
		shot(12);
		hand.key(KeyEvent.VK_SPACE);
		shot(8);
		drag(result);
		hand.key(KeyEvent.VK_Z, KeyEvent.VK_CONTROL);
		rest();
		shot(8);
		film.close();
		hand.key(KeyEvent.VK_S);
		Windows.await("saved", () -> ((JLabel) find("status")).getText().startsWith("Saved in"));
		final Frame review = window;
		SwingUtilities.invokeLater(
			() -> review.dispatchEvent(new WindowEvent(review, WindowEvent.WINDOW_CLOSING)));
		Windows.await("end of the review", () -> !review.isShowing());
	}

	/** The middle of the contour is drawn a little aside, and let go. */
	private void drag(final Path result) throws Exception {
		final Polyline contour = ContourInput.read(result).contours()
			.get(image.getCurrentSlice() - 1).orElseThrow();
		final ImageCanvas canvas = image.getCanvas();
		final Point corner = canvas.getLocationOnScreen();
		final var held = contour.at(0.7 * contour.length());
		final int x = corner.x + canvas.screenXD(held.x() + 0.5),
			y = corner.y + canvas.screenYD(held.y() + 0.5);
		hand.mouseMove(x, y);
		hand.mousePress(InputEvent.BUTTON1_DOWN_MASK);
		for (int i = 1; i <= 4; i++) {
			hand.mouseMove(x + 3 * i, y - 7 * i);
			shot(3);
		}
		hand.mouseRelease(InputEvent.BUTTON1_DOWN_MASK);
		hand.delay(100);
		shot(4);
		rest();
		shot(10);
	}

	private void rest() throws Exception {
		Windows.await("rest", () -> !((JLabel) find("status")).getText().endsWith("..."));
		hand.waitForIdle();
	}

	private void measure() throws Exception {
		image.changes = false;
		image.close();
		IJ.run("Resolve Filament...", "movie=[" + home.resolve("clear.tif") + "] tables=false");
		image = IJ.getImage();
		image.getWindow().setLocation(10, 10);
		Windows.start("Measure Contours...");
		Windows.press(Windows.dialog("Measure Contours..."), "OK");
		window = Windows.frame("Measurements of clear.tif");
		IJ.log(CLOSE_LOG);
		window.setLocation(image.getWindow().getWidth() + 20, 60);
		window.toFront();
		final JTabbedPane tabs = (JTabbedPane) find("tabs 1");
		SwingUtilities.invokeAndWait(() -> tabs.setSelectedIndex(tabs.indexOfTab("Kymographs")));
		hand.delay(500);
		move(find("figure tangent_angle_kymograph"), 0.5, 0.4);
		hand.click();
		hand.delay(500);
		gallery.take("measurements.png", both(), window);
		window.dispose();
		image.changes = false;
		image.close();
	}

	private void batch() throws Exception {
		Files.writeString(home.resolve("sheet.csv"),
			"FileName,FolderPath,requiresManual\nclear.tif,.,False\nnoisy.tif,.,True\nstill.tif,.,False\n");
		new FileSaver(new ImagePlus("still.tif", SampleMovie.open().getProcessor()))
			.saveAsTiff(home.resolve("still.tif").toString());
		final Path out = home.resolve("batch");
		Windows.start("Batch...");
		final var dialog = Windows.dialog("Batch...", "Input");
		Windows.type(dialog, "Input", home.resolve("sheet.csv").toString());
		Windows.type(dialog, "Out", out.toString());
		Windows.press(dialog, "OK");
		window = Windows.frame("Batch batch");
		IJ.log(CLOSE_LOG);
		Windows.onEvents(window::toFront);
		// Small pictures are read in the background.
		hand.delay(3000);
		gallery.take("batch.png", window.getBounds(), window);
	}

	private Rectangle both() {
		return image.getWindow().getBounds().union(window.getBounds());
	}

	/** Pictures of the film, each so many tenths of a second long. */
	private void shot(final int tenths) throws Exception {
		hand.waitForIdle();
		final Rectangle part = both();
		film.add(scaled(withMouse(hand.createScreenCapture(part), part)), tenths);
	}

	/** A capture of the screen has no mouse. */
	private static BufferedImage withMouse(final BufferedImage picture, final Rectangle part) {
		final Point at = MouseInfo.getPointerInfo().getLocation();
		final int x = at.x - part.x, y = at.y - part.y;
		final Graphics2D g = picture.createGraphics();
		g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
		final Polygon arrow = new Polygon(new int[]{x, x, x + 6, x + 17},
			new int[]{y, y + 24, y + 18, y + 17}, 4);
		g.setColor(Color.WHITE);
		g.fill(arrow);
		g.setColor(Color.BLACK);
		g.draw(arrow);
		g.dispose();
		return picture;
	}

	private static BufferedImage scaled(final BufferedImage picture) {
		final int width = (int) (FILM_SCALE * picture.getWidth()),
			height = (int) (FILM_SCALE * picture.getHeight());
		final BufferedImage small = new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB);
		final Graphics2D g = small.createGraphics();
		g.setRenderingHint(RenderingHints.KEY_INTERPOLATION,
			RenderingHints.VALUE_INTERPOLATION_BICUBIC);
		g.drawImage(picture, 0, 0, width, height, null);
		g.dispose();
		return small;
	}

	private void press(final String words) throws Exception {
		move(find(words), 0.5, 0.5);
		shot(3);
		hand.click();
	}

	private void move(final Component component, final double across, final double down) {
		final Point at = component.getLocationOnScreen();
		hand.mouseMove(at.x + (int) (across * component.getWidth()),
			at.y + (int) (down * component.getHeight()));
		hand.waitForIdle();
	}

	private Component find(final String name) {
		return Windows.find(window, name);
	}
}
