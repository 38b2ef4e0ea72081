package io.github.knotresolver.command;

import java.awt.Dialog;
import java.awt.Frame;
import java.awt.event.KeyEvent;
import java.util.Arrays;
import java.util.Map;
import java.util.TreeMap;

import javax.swing.JSpinner;

import ij.ImagePlus;

/** {@code Tune Segmentation...} with mouse and keys. */
final class TuneScenes {

	private static final String TUNE = "Tune Segmentation...";
	private final Hand hand;

	private TuneScenes() throws Exception {
		hand = new Hand(20);
	}

	static Map<String, DialogsMain.Scene> scenes() {
		return new TreeMap<>(
			Map.of("a segmentation is tuned and used", () -> new TuneScenes().tune(),
				"tuning needs an image, and goes with it", () -> new TuneScenes().images()));
	}

	private void tune() throws Exception {
		final ImagePlus image = DialogsMain.sample("tuned");
		final Frame window = open(image);
		final double automatic = area(image);
		hand.clickUntil("frame 13", Windows.find(window, "strip"),
			() -> image.getCurrentSlice() == 13 && area(image) > 0
				&& Windows.text(window).contains("frame 13: "));
		image.setSlice(2);
		Windows.await("frame 2", () -> Windows.text(window).contains("frame 2: "));
		hand.until("threshold", () -> hand.click(Windows.find(window, "histogram"), 0.9, 0.5),
			() -> Math.abs(
				((Number) ((JSpinner) Windows.find(window, "threshold")).getValue()).doubleValue()
					- 0.9) < 0.02);
		Windows.await("smaller mask", () -> area(image) > 0 && area(image) < automatic);
		hand.clickUntil("Use in Resolve", Windows.find(window, "Use in Resolve"),
			() -> !window.isShowing());
		final Dialog dialog = Windows.dialog("Resolve Filament...");
		DialogsMain.require(!window.isShowing(), "The window stays.");
		DialogsMain.require(Windows.field(dialog, "Threshold").getText().startsWith("0."),
			Windows.field(dialog, "Threshold").getText());
		DialogsMain.require(Windows.text(dialog).contains("threshold=0."),
			"What differs is not named: " + Windows.text(dialog));
		Windows.press(dialog, "Cancel");
		Windows.await("end", () -> !dialog.isShowing() && image.getOverlay() == null);
	}

	private void images() throws Exception {
		Windows.start(TUNE);
		Windows.press(Windows.dialog(TUNE), "OK");
		Windows.message("There is no image open; open a movie, and tune it then.");
		final ImagePlus image = DialogsMain.sample("closed");
		final Frame window = open(image);
		image.close();
		Windows.await("end", () -> !window.isShowing());
		final ImagePlus other = DialogsMain.sample("escaped");
		final Frame again = open(other);
		hand.focus(again, Windows.find(again, "Close"));
		hand.key(KeyEvent.VK_ESCAPE);
		Windows.await("end", () -> !again.isShowing() && other.getOverlay() == null);
	}

	private static Frame open(final ImagePlus image) throws Exception {
		Windows.start(TUNE);
		Windows.press(Windows.dialog(TUNE), "OK");
		final String title = "Tune " + image.getTitle();
		final Frame window = Windows.frame(title);
		Windows.await("mask", () -> area(image) > 0);
		return window;
	}

	/** Pixels inside the outline that is drawn. */
	private static double area(final ImagePlus image) {
		return image.getOverlay() == null
			? 0
			: Arrays.stream(image.getOverlay().toArray())
				.filter(r -> "look-mask".equals(r.getName()))
				.mapToDouble(r -> r.getStatistics().pixelCount).sum();
	}
}
