package io.github.knotresolver.command;

import java.awt.AWTException;
import java.awt.Component;
import java.awt.Dialog;
import java.awt.Frame;
import java.awt.Rectangle;
import java.awt.Robot;
import java.awt.TextArea;
import java.awt.event.KeyEvent;
import java.awt.event.WindowEvent;
import java.awt.image.BufferedImage;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.concurrent.CopyOnWriteArraySet;
import java.util.concurrent.atomic.AtomicBoolean;

import javax.swing.JCheckBox;
import javax.swing.JLabel;
import javax.swing.JTextField;

import ij.IJ;
import ij.ImageJ;
import ij.ImagePlus;
import ij.WindowManager;
import ij.gui.ImageCanvas;
import ij.gui.Overlay;
import ij.gui.PointRoi;
import ij.gui.Roi;
import ij.measure.Calibration;
import ij.plugin.frame.Recorder;
import ij.plugin.frame.RoiManager;
import ij.text.TextWindow;
import io.github.knotresolver.imagej.SampleMovie;

/**
 * Plain ImageJ on a display, driven through its own windows: one scene after the
 * other, each from a clean start. Prints what came of each for
 * {@link DialogsTest}.
 */
final class DialogsMain {

	static final String PASSED = "passed: ", FAILED = "failed: ";

	/** The result folder of a scene. */
	static final String RECORDED = "recorded first";

	private static final String RESOLVE = "Resolve Filament...";

	/** What a person does, and what must come of it. */
	interface Scene {

		void play() throws Exception;
	}

	private final Path home;

	private DialogsMain(final Path home) {
		this.home = home;
	}

	/** @return the scenes by name, in their order */
	static Set<String> names() {
		return new DialogsMain(Path.of("")).scenes().keySet();
	}

	public static void main(final String[] args) throws Exception {
		new ImageJ();
		IJ.run("Record...");
		final DialogsMain main = new DialogsMain(Path.of(args[0]));
		for (final Map.Entry<String, Scene> scene : main.scenes().entrySet()) {
			if (args.length > 1 && !scene.getKey().contains(args[1]))
				continue;
			main.clean();
			try {
				scene.getValue().play();
				require(Windows.dialogs().findAny().isEmpty(), "A dialog is still open.");
				System.out.println(PASSED + scene.getKey());
			} catch (final Exception | AssertionError e) {
				System.out.println(FAILED + scene.getKey() + ": " + e);
				e.printStackTrace(System.out);
			}
		}
		System.exit(0);
	}

	private Map<String, Scene> scenes() {
		final Map<String, Scene> scenes = new LinkedHashMap<>();
		scenes.put("calibration is asked for and recorded", this::calibrationIsAskedFor);
		scenes.put("giving up the calibration gives up all", this::calibrationCanBeGivenUp);
		scenes.put("calibration is not asked for if the dialog told it", this::calibrationTold);
		scenes.put("a unit in doubt is asked for", this::unitInDoubt);
		scenes.put("slices are swapped with frames if wanted", this::zIsTime);
		scenes.put("a Z-stack that is none is refused", this::zIsNotTime);
		scenes.put("another image than the active one is chosen", this::imageIsChosen);
		scenes.put("a point selection is the fixed end", this::pointIsFixedEnd);
		scenes.put("an area selection limits the search", this::areaIsRegion);
		scenes.put("Esc in the middle leaves ImageJ clean", this::escape);
		scenes.put("no open image", this::noImage);
		scenes.put("RGB is refused with advice", this::rgb);
		scenes.put("one frame is no movie", this::oneFrame);
		scenes.put("a wrong value is marked in the dialog, which stays", this::wrongValue);
		scenes.put("a simulation is recorded and replayed", this::simulationIsRecorded);
		scenes.put("the image is large and in front at the end", this::imageIsInFront);
		scenes.put("closing the dialog does nothing", this::dialogIsClosed);
		scenes.put("a missing movie file", this::missingFile);
		scenes.put("a batch without its folder", this::batchWithoutFolder);
		scenes.put("two runs leave one result and the user's own ROIs", this::twice);
		scenes.put("overlay, ROIs and tables only if wanted", this::nothingShown);
		scenes.put("a title with spaces, brackets and letters of all kinds", this::title);
		scenes.put("the image is closed meanwhile", this::imageIsClosed);
		scenes.put("the recorded line does the same", this::replay);
		scenes.put("nothing pops up in a macro", this::macroIsQuiet);
		scenes.put("a macro in batch mode opens no ROI Manager", this::batchMode);
		scenes.put("a hidden image stays hidden", this::hiddenImage);
		scenes.put("the ROI Manager is measured", this::measure);
		scenes.putAll(PreviewScenes.scenes());
		scenes.putAll(RunScenes.scenes());
		scenes.putAll(TuneScenes.scenes());
		scenes.putAll(WindowScenes.scenes(home));
		return scenes;
	}

	private void calibrationIsAskedFor() throws Exception {
		final ImagePlus image = uncalibrated();
		image.show();
		ok("1-3");
		final Dialog question = Windows.dialog(RESOLVE, "does not say how large its pixels are",
			"nor how long a frame lasts");
		Windows.type(question, "Pixel size", "0.5");
		Windows.type(question, "Frame interval", "3");
		Windows.press(question, "OK");
		finished();
		require(tables().contains(image.getTitle() + "-frames"), "tables: " + tables());
		require(recorded().contains("pixel_size=0.5 frame_interval=3"), recorded());
		require(image.getCalibration().getUnit().startsWith("pixel"), "The image was changed.");
	}

	private void calibrationCanBeGivenUp() throws Exception {
		final ImagePlus image = uncalibrated();
		image.show();
		ok("1-3");
		Windows.press(Windows.dialog(RESOLVE, "does not say"), "Cancel");
		Thread.sleep(500);
		require(image.getOverlay() == null && log().isEmpty(), "It went on: " + log());
	}

	private void calibrationTold() throws Exception {
		uncalibrated().show();
		Windows.start(RESOLVE);
		final Dialog dialog = Windows.dialog(RESOLVE);
		Windows.type(dialog, "Frames", "1-3");
		Windows.type(dialog, "Pixel size", "0.5");
		Windows.type(dialog, "Frame interval", "3");
		Windows.press(dialog, "OK");
		finished();
	}

	private void unitInDoubt() throws Exception {
		final ImagePlus image = sample("in nm");
		image.getCalibration().pixelWidth = image.getCalibration().pixelHeight = 106;
		image.getCalibration().setUnit("nm");
		Windows.start(RESOLVE);
		final Dialog dialog = Windows.dialog(RESOLVE, "Threshold");
		Windows.type(dialog, "Frames", "1-3");
		Windows.type(dialog, "Pixel size", "0.106");
		Windows.press(dialog, "OK");
		Windows.press(Windows.dialog(RESOLVE, "says that its pixels are 106.0 nm large"), "OK");
		finished();
		require(log().contains("pixel_size=0.106 unit=µm "), log());
	}

	private void zIsTime() throws Exception {
		final ImagePlus image = zStack();
		ok("1-3");
		Windows.press(Windows.dialog(RESOLVE, "Are its slices frames?"), "Yes");
		finished();
		require(image.getNSlices() == 24 && image.getNFrames() == 1, "The image was changed.");
		require(image.getOverlay().get(16).getPosition() == 2, "The ROI is on another slice.");
		require(recorded().contains("z_as_time=true "), recorded());
	}

	private void zIsNotTime() throws Exception {
		final ImagePlus image = zStack();
		ok("1-3");
		Windows.press(Windows.dialog(RESOLVE, "Are its slices frames?"), "No");
		Windows.message("is a Z-stack of 24 slices, not a time series");
		require(image.getOverlay() == null, "It went on.");
	}

	private void imageIsChosen() throws Exception {
		final ImagePlus wanted = sample("wanted");
		final ImagePlus active = sample("active");
		Windows.start(RESOLVE);
		final Dialog dialog = Windows.dialog(RESOLVE);
		Windows.choose(dialog, "Image", "wanted");
		Windows.type(dialog, "Frames", "1-3");
		Windows.press(dialog, "OK");
		finished();
		require(wanted.getOverlay() != null && active.getOverlay() == null, "The other was taken.");
		require(recorded().contains("image=wanted "), recorded());
	}

	private void pointIsFixedEnd() throws Exception {
		sample("point").setRoi(new PointRoi(20.0, 24.0));
		ok("1-3");
		finished();
		require(log().contains("fixed_end=20.0,24.0 "), log());
	}

	private void areaIsRegion() throws Exception {
		sample("area").setRoi(4, 0, 90, 50);
		ok("1-3");
		finished();
		require(log().contains("Only the region x=4 y=0 width=90 height=50 was searched."), log());
	}

	private void escape() throws Exception {
		final ImagePlus image = sample("escape");
		final Set<String> before = tables();
		ok("");
		inTheMiddle();
		image.getCanvas().dispatchEvent(new KeyEvent(image.getCanvas(), KeyEvent.KEY_PRESSED,
			System.currentTimeMillis(), 0, KeyEvent.VK_ESCAPE, KeyEvent.CHAR_UNDEFINED));
		Windows.message("Cancelled; nothing was written.");
		require(image.getOverlay() == null && rois() == 0 && tables().equals(before),
			"Something is left: " + tables());
		require(!IJ.escapePressed() && !image.isLocked() && !running(), "ImageJ is not clean.");
		ok("1-3");
		finished();
	}

	private void noImage() throws Exception {
		ok("");
		Windows.message("There is no image open; open a movie, or name its file with movie=FILE.");
	}

	private void rgb() throws Exception {
		final ImagePlus image = IJ.createImage("rgb", "RGB black", 50, 50, 1);
		image.getProcessor().set(3, 3, 0xff0000);
		image.getStack().addSlice(image.getProcessor().duplicate());
		image.setStack(image.getStack());
		image.setDimensions(1, 1, 2);
		image.getCalibration().frameInterval = 1;
		image.getCalibration().setUnit("um");
		image.show();
		ok("");
		Windows
			.message("is an RGB image, but intensities are needed; convert it with Image > Type");
		image.changes = false;
	}

	private void oneFrame() throws Exception {
		final ImagePlus image = SampleMovie.open();
		final ImagePlus one = new ImagePlus("single", image.getProcessor());
		one.setCalibration(image.getCalibration());
		one.show();
		ok("");
		Windows.message("'single' has one frame only");
	}

	private void wrongValue() throws Exception {
		sample("wrong");
		Windows.start(RESOLVE);
		final Dialog dialog = Windows.dialog(RESOLVE);
		Windows.type(dialog, "Iterations", "1001");
		Windows.type(dialog, "Length (if", "15");
		Windows.press(dialog, "OK");
		Windows.dialog(RESOLVE, "iterations must be a whole number from 0 to 1000");
		require(dialog.isShowing() && Windows.dialogs().count() == 1, "It is another dialog.");
		final JTextField wrong = Windows.field(dialog, "Iterations");
		require(wrong.getText().equals("1001") && isMarked(dialog, "Iterations"),
			"It is not marked.");
		require(Windows.field(dialog, "Length (if").getText().equals("15"), "15 is lost.");
		Windows.type(dialog, "Iterations", "10");
		Windows.type(dialog, "Frames", "1-99");
		Windows.press(dialog, "OK");
		// That the movie has fewer frames shows when it is read: the dialog comes again.
		// The preview may say it before, in the dialog that goes.
		Windows.await("the mark", () -> Windows.dialogs()
			.anyMatch(d -> RESOLVE.equals(d.getTitle()) && isMarked(d, "Frames")));
		final Dialog again = Windows.dialog(RESOLVE, "frames names frame 99");
		require(Windows.field(again, "Length (if").getText().equals("15"), "15 is lost.");
		require(recorded().isEmpty(), recorded());
		Windows.type(again, "Frames", "1-3");
		Windows.press(again, "OK");
		finished();
		Windows.await("line", () -> recorded().contains("frames=1-3"));
		require(!recorded().contains("1-99"), recorded());
	}

	private static boolean isMarked(final Dialog dialog, final String label) {
		return Windows.field(dialog, label).getBackground().getGreen() < 230;
	}

	/** Its keys are many, and end alike. */
	private void simulationIsRecorded() throws Exception {
		Windows.start("Simulate Movie...");
		final Dialog dialog = Windows.dialog("Simulate Movie...");
		Windows.type(dialog, "Frames", "3");
		Windows.type(dialog, "Duration", "1");
		Windows.type(dialog, "Length", "5");
		Windows.type(dialog, "Out", home.resolve("out force movie").toString());
		for (final JCheckBox box : Windows.all(dialog, JCheckBox.class))
			Windows.set(dialog, box.getText(), true);
		Windows.press(dialog, "OK");
		Windows.await("movie", () -> WindowManager.getImageCount() == 1);
		final String start = "run(\"Simulate Movie...\", \"length=5 ";
		Windows.await("line", () -> Recorder.getInstance().getText().contains(start));
		final String line = Recorder.getInstance().getText().lines()
			.filter(l -> l.startsWith(start)).findFirst().orElseThrow();
		require(line.contains("stall_load=6") && line.contains("force=true"), line);
		IJ.runMacro(line);
		require(WindowManager.getImageCount() == 2, "Not replayed: " + line + log());
	}

	private void imageIsInFront() throws Exception {
		IJ.run("Knotted Filament");
		final ImagePlus image = WindowManager.getCurrentImage();
		final int whole = image.getCanvas().getWidth();
		require(whole >= 300, "The sample is " + whole + " pixels wide.");
		ok("1-3");
		finished();
		final ImageCanvas canvas = image.getCanvas();
		require(canvas.getMagnification() >= 3, "magnified " + canvas.getMagnification());
		require(image.getOverlay() != null && WindowManager.getCurrentImage() == image,
			"It is not the active image.");
		require(WindowManager.getWindow("Log") != null, "There is no log.");
		// Tables and log are white, the image is dark.
		Windows.await("front", () -> brightness(canvas) < 128);
	}

	private static double brightness(final Component component) throws AWTException {
		final BufferedImage seen = new Robot().createScreenCapture(
			new Rectangle(component.getLocationOnScreen(), component.getSize()));
		return new ImagePlus("seen", seen).getProcessor().convertToByte(false).getStats().mean;
	}

	private void dialogIsClosed() throws Exception {
		final ImagePlus image = sample("closed");
		Windows.start(RESOLVE);
		final Dialog dialog = Windows.dialog(RESOLVE);
		dialog.dispatchEvent(new WindowEvent(dialog, WindowEvent.WINDOW_CLOSING));
		Windows.await("end", () -> !dialog.isShowing());
		Thread.sleep(300);
		require(image.getOverlay() == null && log().isEmpty() && recorded().isEmpty(),
			"It went on: " + log() + recorded());
	}

	private void missingFile() throws Exception {
		Windows.start(RESOLVE);
		final Dialog dialog = Windows.dialog(RESOLVE);
		Windows.type(dialog, "Movie (file)", home.resolve("absent.tif").toString());
		Windows.press(dialog, "OK");
		Windows.message("There is no file " + home.resolve("absent.tif"));
	}

	private void batchWithoutFolder() throws Exception {
		Windows.start("Batch...");
		Windows.press(Windows.dialog("Batch..."), "OK");
		Windows.message("input is missing; name a sheet or a folder of movies as input");
		Windows.start("Batch...");
		final Dialog dialog = Windows.dialog("Batch...");
		Windows.type(dialog, "Input", home.resolve("absent").toString());
		Windows.type(dialog, "Out", home.resolve("batch").toString());
		Windows.press(dialog, "OK");
		Windows.message(home.resolve("absent").toString());
	}

	private void twice() throws Exception {
		final ImagePlus image = sample("twice");
		final Roi own = new Roi(1, 1, 5, 5);
		own.setName("own");
		RoiManager.getRoiManager().addRoi(own);
		image.setOverlay(new Overlay(new Roi(2, 2, 3, 3)));
		for (int run = 0; run < 2; run++) {
			ok("1-3");
			finished();
			IJ.log("\\Clear");
		}
		require(rois() == 4 && RoiManager.getRoiManager().getName(0).equals("own"),
			rois() + " ROIs");
		require(image.getOverlay().size() == 1 + 3 * 16, image.getOverlay().size() + " shapes");
		require(tables().equals(Set.of("twice-contours", "twice-filaments", "twice-frames")),
			tables().toString());
		require(!recorded().contains("roiManager"), recorded());
	}

	private void nothingShown() throws Exception {
		final ImagePlus image = sample("bare");
		Windows.start(RESOLVE);
		final Dialog dialog = Windows.dialog(RESOLVE);
		Windows.type(dialog, "Frames", "1-3");
		for (final String box : List.of("Overlay", "ROI manager", "Tables"))
			Windows.set(dialog, box, false);
		Windows.press(dialog, "OK");
		finished();
		require(image.getOverlay() == null && rois() == 0 && tables().isEmpty(), "Shown.");
		require(recorded().contains("overlay=false roi_manager=false tables=false"), recorded());
	}

	private void title() throws Exception {
		final ImagePlus odd = sample("Zelle 7 [µ-tubule] (2) α.b.tif");
		sample("other");
		Windows.start(RESOLVE);
		final Dialog dialog = Windows.dialog(RESOLVE);
		Windows.choose(dialog, "Image", odd.getTitle());
		Windows.type(dialog, "Frames", "1-3");
		Windows.press(dialog, "OK");
		finished();
		require(tables().contains(odd.getTitle() + "-frames"), tables().toString());
		odd.setOverlay(null);
		IJ.runMacro(recorded());
		require(odd.getOverlay() != null, "Not replayed: " + recorded() + log());
		require(rois() == 3, rois() + " ROIs");
	}

	private void imageIsClosed() throws Exception {
		final ImagePlus image = sample("closing");
		ok("");
		inTheMiddle();
		image.changes = false;
		image.close();
		finished();
		require(rois() == 24 && tables().contains("closing-frames"), rois() + " ROIs");
	}

	private void replay() throws Exception {
		final Path first = home.resolve(RECORDED), second = home.resolve("recorded second");
		sample("replay");
		Windows.start(RESOLVE);
		final Dialog dialog = Windows.dialog(RESOLVE);
		Windows.type(dialog, "Out (result", first.toString());
		Windows.press(dialog, "OK");
		finished();
		final String line = recorded();
		require(line.contains(first.toString()), line);
		IJ.runMacro(line.replace(first.toString(), second.toString()));
		require(Files.mismatch(first.resolve("contours.csv"), second.resolve("contours.csv")) == -1,
			"The contours differ.");
	}

	private void macroIsQuiet() throws Exception {
		uncalibrated().show();
		final Set<String> popped = new CopyOnWriteArraySet<>();
		final AtomicBoolean over = new AtomicBoolean();
		final Thread watch = new Thread(() -> {
			while (!over.get())
				Windows.dialogs().forEach(d -> popped.add(d.getTitle() + Windows.text(d)));
		});
		watch.start();
		IJ.runMacro("run(\"" + RESOLVE + "\", \"frames=1-3\");");
		require(log().contains("Time: "), log());
		IJ.runMacro("run(\"" + RESOLVE + "\", \"frames=1-3 treshold=2\");");
		require(log().contains("There is no key 'treshold'"), log());
		IJ.runMacro("run(\"" + RESOLVE + "\", \"frames=1-300\");");
		over.set(true);
		watch.join();
		require(popped.isEmpty(), popped.toString());
	}

	private void batchMode() throws Exception {
		final String count = IJ.runMacro("setBatchMode(true); run(\"Knotted Filament\"); run(\""
			+ RESOLVE + "\", \"frames=1-3 tables=false\"); return \"\" + roiManager(\"count\");");
		require("3".equals(count), count + " ROIs");
		require(RoiManager.getRawInstance() == null, "The ROI Manager came up.");
		require(WindowManager.getImageCount() == 0, "An image came up.");
	}

	private void hiddenImage() throws Exception {
		final ImagePlus hidden = SampleMovie.open();
		sample("visible");
		IJ.run(hidden, RESOLVE, "frames=1-3");
		require(hidden.getOverlay() != null && hidden.getWindow() == null, "Not the hidden one.");
		require(WindowManager.getCurrentImage().getOverlay() == null, "The visible one was taken.");
	}

	private void measure() throws Exception {
		sample("measured");
		ok("");
		finished();
		Windows.start("Measure Contours...");
		Windows.press(Windows.dialog("Measure Contours..."), "OK");
		Windows.await("window", () -> measurements().isPresent());
		require(WindowManager.getImageCount() == 1, "There are more windows than one.");
		measurements().orElseThrow().dispose();
	}

	private static Optional<Frame> measurements() {
		return Arrays.stream(Frame.getFrames())
			.filter(f -> f.isShowing() && f.getTitle().equals("Measurements of measured"))
			.findAny();
	}

	/** Starts, fills in the frames, and presses OK. */
	private static void ok(final String frames) throws Exception {
		Windows.start(RESOLVE);
		final Dialog dialog = Windows.dialog(RESOLVE, "Threshold");
		Windows.type(dialog, "Frames", frames);
		Windows.press(dialog, "OK");
	}

	static void finished() throws Exception {
		Windows.await("end", () -> log().contains("Time: ") && !running());
	}

	/** The status line tells the stage. */
	private static void inTheMiddle() throws Exception {
		Windows.await("a stage", () -> Windows.all(IJ.getInstance().getStatusBar(), JLabel.class)
			.stream().anyMatch(l -> l.getText() != null && l.getText().endsWith("...")));
	}

	private static boolean running() {
		return Thread.getAllStackTraces().keySet().stream()
			.anyMatch(t -> t.getName().equals(RESOLVE));
	}

	static String log() {
		return IJ.getLog() == null ? "" : IJ.getLog();
	}

	private static Set<String> tables() {
		return new TreeSet<>(
			Arrays.stream(WindowManager.getNonImageTitles()).filter(t -> t.contains("-")).toList());
	}

	private static int rois() {
		return RoiManager.getRawInstance() == null ? 0 : RoiManager.getRawInstance().getCount();
	}

	/** The last line of the recorder that runs the Command. */
	private static String recorded() {
		final String text = Recorder.getInstance().getText();
		final int at = text.lastIndexOf("run(\"" + RESOLVE);
		return at < 0 ? "" : text.substring(at).lines().findFirst().orElseThrow();
	}

	static ImagePlus sample(final String title) {
		final ImagePlus image = SampleMovie.open();
		image.setTitle(title);
		image.show();
		return image;
	}

	private static ImagePlus uncalibrated() {
		final ImagePlus image = SampleMovie.open();
		image.setCalibration(new Calibration());
		return image;
	}

	private static ImagePlus zStack() {
		final ImagePlus image = SampleMovie.open();
		image.setDimensions(1, image.getStackSize(), 1);
		image.show();
		return image;
	}

	/** No image, table, ROI or line of an earlier scene. */
	private void clean() {
		Windows.closeDialogs();
		for (final int id : WindowManager.getIDList() == null
			? new int[0]
			: WindowManager.getIDList()) {
			final ImagePlus image = WindowManager.getImage(id);
			image.changes = false;
			image.close();
		}
		final List<Frame> frames = new ArrayList<>(
			Arrays.asList(WindowManager.getNonImageWindows()));
		frames.stream().filter(f -> !(f instanceof Recorder)).forEach(f -> {
			if (f instanceof RoiManager manager)
				manager.close();
			else if (f instanceof TextWindow window)
				window.close(false);
		});
		IJ.log("\\Clear");
		Recorder.setCommand(null);
		clearRecorder();
	}

	private static void clearRecorder() {
		Windows.all(Recorder.getInstance(), TextArea.class).forEach(a -> a.setText(""));
	}

	static void require(final boolean condition, final String otherwise) {
		if (!condition)
			throw new AssertionError(otherwise);
	}
}
