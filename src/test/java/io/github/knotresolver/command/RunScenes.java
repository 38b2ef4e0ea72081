package io.github.knotresolver.command;

import java.awt.Component;
import java.awt.Container;
import java.awt.Dialog;
import java.awt.Frame;
import java.awt.event.WindowEvent;
import java.util.Arrays;
import java.util.Map;
import java.util.TreeMap;

import javax.swing.JButton;

import ij.IJ;
import ij.ImagePlus;
import ij.ImageStack;

/** A run as a person watches it: the window with Cancel, contours as they are found, the review. */
final class RunScenes {

	private static final String RESOLVE = "Resolve Filament...";
	private final Hand hand;

	private RunScenes() throws Exception {
		hand = new Hand(20);
	}

	static Map<String, DialogsMain.Scene> scenes() {
		return new TreeMap<>(Map.of("a run draws what it finds and leads to the review",
			() -> new RunScenes().outcome(), "Cancel beside Esc stops a run",
			() -> new RunScenes().cancel(), "the window of a run goes with its image",
			() -> new RunScenes().imageCloses()));
	}

	private void outcome() throws Exception {
		final ImagePlus image = DialogsMain.sample("watched");
		begin("");
		Windows.await("sightings",
			() -> image.getOverlay() != null && Arrays.stream(image.getOverlay().toArray())
				.anyMatch(r -> "look-sighted".equals(r.getName())));
		DialogsMain.finished();
		final Frame window = Windows.frame("Resolved watched",
			t -> t.startsWith("Resolved watched"));
		Windows.await("outcome",
			() -> Windows.text(window).contains("24 frames right, 0 doubtful"));
		DialogsMain.require(image.getOverlay().size() == 24 * 16,
			image.getOverlay().size() + " shapes: sightings stay.");
		hand.clickUntil("Review", button(window, "Review"),
			() -> Windows.shown(t -> t.startsWith("Review ")).isPresent());
		final Frame review = Windows.frame("Review ", t -> t.startsWith("Review "));
		Windows.await("end", () -> !window.isShowing());
		review.dispatchEvent(new WindowEvent(review, WindowEvent.WINDOW_CLOSING));
		Windows.await("end of the review", () -> !review.isShowing());
	}

	private void cancel() throws Exception {
		final ImagePlus once = DialogsMain.sample("once");
		final ImageStack frames = new ImageStack(once.getWidth(), once.getHeight());
		for (int i = 0; i < 10; i++)
			for (int t = 1; t <= once.getStackSize(); t++)
				frames.addSlice(once.getStack().getProcessor(t).duplicate());
		final ImagePlus image = new ImagePlus("long", frames);
		image.setDimensions(1, 1, frames.size());
		image.setCalibration(once.getCalibration());
		once.close();
		image.show();
		begin("");
		final Frame window = Windows.frame("Resolving long", t -> t.startsWith("Resolving long"));
		Windows.await("stage", () -> !Windows.text(window).contains("Beginning"));
		hand.clickUntil("cancelled", button(window, "Cancel"),
			() -> !window.isShowing() || Windows.dialogs().findAny().isPresent());
		Windows.message("Cancelled; nothing was written.");
		Windows.await("end", () -> !window.isShowing());
		DialogsMain.require(image.getOverlay() == null && !IJ.escapePressed() && !image.isLocked(),
			"ImageJ is not clean.");
	}

	private void imageCloses() throws Exception {
		final ImagePlus image = DialogsMain.sample("closing");
		begin("1-3");
		DialogsMain.finished();
		final Frame window = Windows.frame("Resolved closing",
			t -> t.startsWith("Resolved closing"));
		image.close();
		Windows.await("end", () -> !window.isShowing());
	}

	private static void begin(final String frames) throws Exception {
		Windows.start(RESOLVE);
		final Dialog dialog = Windows.dialog(RESOLVE);
		Windows.set(dialog, "Preview", false);
		Windows.type(dialog, "Frames", frames);
		Windows.press(dialog, "OK");
	}

	private static Component button(final Container window, final String name) {
		return Windows.all(window, JButton.class).stream().filter(b -> name.equals(b.getName()))
			.findFirst().orElseThrow();
	}
}
