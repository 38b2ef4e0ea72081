package io.github.knotresolver.command;

import java.awt.Dialog;
import java.awt.Frame;
import java.awt.Point;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.lang.management.ManagementFactory;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.concurrent.Callable;

import javax.swing.JButton;
import javax.swing.JLabel;
import javax.swing.JTextArea;

import com.sun.management.OperatingSystemMXBean;

import ij.IJ;
import ij.ImageJ;
import ij.ImagePlus;
import ij.ImageStack;
import ij.gui.ImageCanvas;
import ij.gui.Overlay;
import ij.gui.Roi;
import ij.process.FloatPolygon;
import ij.process.FloatProcessor;
import io.github.knotresolver.fit.DrawnMovie;
import io.github.knotresolver.fit.LineModel;
import io.github.knotresolver.image.Pixels;
import io.github.knotresolver.imagej.TestImages;
import io.github.knotresolver.model.Movie;

/**
 * How long a person takes from a movie's file to checked contours: the windows are driven by mouse and
 * keys, what they take to answer is measured, and what a person takes is that of the keystroke-level
 * model (Card, Moran and Newell 1980, DOI 10.1145/358886.358895) with an allowance for every frame that is
 * looked at. The movie has 120 frames, in noise as strong as a strand's brightness is. Started by
 * {@code scripts/clicks}, which gives it a display; its argument is a folder for the movie.
 */
final class ClicksMain {

	private static final String RESOLVE = "Resolve Filament...";
	private static final int FRAMES = 120, PIXELS = 3;
	private static final double NOISE = 0.4;

	/** Seconds: a key or button, pointing, a hand to the mouse or back, getting ready; and our own, a look. */
	private static final Map<Character, Double> SECONDS = Map.of('K', 0.28, 'P', 1.1, 'H', 0.4, 'M',
		1.35, 'L', 5.0);

	private final Hand hand = new Hand(20);
	private final Path home;
	private ImagePlus image;
	private Frame review;
	private double person, program, processors;

	private ClicksMain(final Path home) throws Exception {
		this.home = home;
	}

	public static void main(final String[] args) throws Exception {
		new ImageJ();
		try {
			new ClicksMain(Path.of(args[0])).play();
			System.exit(0);
		} catch (final Throwable e) {
			e.printStackTrace();
			System.exit(1);
		}
	}

	private void play() throws Exception {
		final Path file = movie();
		System.out.println(
			"| step | person | s | program, s | its processors, s |\n|---|---|---|---|---|");
		step("drag the file onto ImageJ", "MPKPK", () -> {
			image = IJ.openImage(file.toString());
			image.show();
		}, () -> image.getWindow() != null);
		step("Plugins > Tracking > KnotResolver > Resolve Filament..., and read the preview",
			"MPKPKPKPKL", () -> Windows.start(RESOLVE),
			() -> Windows.dialogs().anyMatch(d -> Windows.text(d).contains("frame 1: ")));
		final Dialog dialog = Windows.dialog(RESOLVE);
		hand.focus(dialog, Windows.find(dialog, "frames"));
		step("Enter (OK)", "MHK", () -> hand.key(KeyEvent.VK_ENTER),
			() -> Windows.shown(t -> t.startsWith("Resolved ")).isPresent());
		final Frame outcome = Windows.frame("outcome", t -> t.startsWith("Resolved "));
		System.out.println("<!-- " + Windows.text(outcome).strip() + " -->");
		hand.focus(outcome, Windows.all(outcome, JButton.class).get(0));
		step("Enter (Review)", "MK", () -> hand.key(KeyEvent.VK_ENTER),
			() -> Windows.shown(t -> t.startsWith("Review ")).isPresent());
		review = Windows.frame("review", t -> t.startsWith("Review "));
		Windows.await("words", () -> words().startsWith("frame 1 "));
		for (int i = 1; i <= 3; i++)
			correct(i);
		Files.createDirectories(home);
		step("s, and Enter (the folder's name)", "MKMK", () -> {
			key(KeyEvent.VK_S);
			final Dialog chooser = Windows.dialog("A new folder for the result");
			hand.focus(chooser, chooser);
			Windows.press(chooser, "Save");
		}, () -> ((JLabel) Windows.find(review, "status")).getText().startsWith("Saved in"));
		System.out.printf(Locale.ROOT,
			"| together | | %.0f | %.0f | %.0f |%n%.0f s for %d frames.%n", person, program,
			processors, person + program, FRAMES);
	}

	/** The least certain frame comes, and is mended: by an alternative where there is one, else by hand. */
	private void correct(final int number) throws Exception {
		final String before = words();
		step("n, and look at the image", "MKL", () -> key(KeyEvent.VK_N),
			() -> !words().equals(before) && isAtRest());
		if (number == 1 && Windows.named(review, "alternative 2").isPresent())
			step("2 (an alternative)", "MK", () -> key(KeyEvent.VK_2),
				() -> words().contains("corrected") && isAtRest());
		else if (number < 3)
			step("drag the contour", "HMPKPK", this::drag,
				() -> words().contains("corrected") && isAtRest());
		else {
			final String doubtful = words();
			step("space (it is right)", "HMK", () -> key(KeyEvent.VK_SPACE),
				() -> !words().equals(doubtful) && isAtRest());
		}
	}

	private void drag() throws Exception {
		final ImageCanvas canvas = image.getCanvas();
		final Overlay overlay = image.getOverlay();
		final Roi middle = overlay.get(overlay.size() / 2);
		final FloatPolygon line = middle.getFloatPolygon();
		final double column = line.xpoints[0], row = line.ypoints[0];
		hand.over(canvas, (canvas.screenXD(column) + 0.5) / canvas.getWidth(),
			(canvas.screenYD(row) + 0.5) / canvas.getHeight());
		final Point corner = canvas.getLocationOnScreen();
		final int x = corner.x + canvas.screenXD(column), y = corner.y + canvas.screenYD(row),
			far = (int) (PIXELS * canvas.getMagnification());
		hand.mouseMove(x, y);
		hand.mousePress(InputEvent.BUTTON1_DOWN_MASK);
		hand.mouseMove(x + far / 2, y);
		hand.mouseMove(x + far, y);
		hand.mouseRelease(InputEvent.BUTTON1_DOWN_MASK);
		hand.waitForIdle();
	}

	private void step(final String what, final String operators, final Hand.Step step,
		final Callable<Boolean> done) throws Exception {
		final double seconds = operators.chars().mapToDouble(c -> SECONDS.get((char) c)).sum();
		// With what the robot takes: rather too much than too little.
		final long start = System.nanoTime(), begun = cpu();
		step.take();
		Windows.await(what, done);
		final double answer = (System.nanoTime() - start) / 1e9, work = (cpu() - begun) / 1e9;
		person += seconds;
		program += answer;
		processors += work;
		System.out.printf(Locale.ROOT, "| %s | %s | %.1f | %.1f | %.1f |%n", what, operators,
			seconds, answer, work);
	}

	private static long cpu() {
		return ManagementFactory.getOperatingSystemMXBean() instanceof OperatingSystemMXBean system
			? system.getProcessCpuTime()
			: 0;
	}

	private void key(final int code) throws Exception {
		hand.focus(review, review);
		hand.key(code);
	}

	private String words() {
		return ((JTextArea) Windows.find(review, "frame")).getText();
	}

	private boolean isAtRest() {
		return !((JLabel) Windows.find(review, "status")).getText().endsWith("...");
	}

	private Path movie() {
		final Movie drawn = DrawnMovie.draw(DrawnMovie.waves(FRAMES, 80, 3.6), List.of(),
			LineModel.uniform(LineModel.Kind.ADDITIVE, 1.6, 1), NOISE, 41).movie();
		final ImageStack stack = new ImageStack(DrawnMovie.SIZE, DrawnMovie.SIZE);
		for (int t = 0; t < FRAMES; t++)
			stack.addSlice(new FloatProcessor(DrawnMovie.SIZE, DrawnMovie.SIZE,
				Pixels.doubles(drawn.frame(t))));
		final ImagePlus movie = new ImagePlus("movie", stack);
		movie.setDimensions(1, 1, FRAMES);
		movie.getCalibration().setUnit("um");
		movie.getCalibration().pixelWidth = movie.getCalibration().pixelHeight = 0.1;
		movie.getCalibration().frameInterval = 1;
		return TestImages.save(movie, home.resolve("movie.tif"));
	}
}
