package io.github.knotresolver.command;

import java.awt.Dialog;
import java.awt.event.KeyEvent;
import java.util.Arrays;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Stream;

import javax.swing.JButton;
import javax.swing.JCheckBox;
import javax.swing.JComponent;

import ij.ImagePlus;
import ij.WindowManager;
import ij.gui.Overlay;
import ij.gui.PointRoi;
import ij.gui.Roi;

/** The dialog of {@code Resolve Filament...} with mouse and keys: its preview, and what is closed. */
final class PreviewScenes {

	private static final String RESOLVE = "Resolve Filament...";
	private final Hand hand;

	PreviewScenes() throws Exception {
		hand = new Hand(20);
	}

	/** Robots need a display; names do not. */
	static Map<String, DialogsMain.Scene> scenes() {
		return new TreeMap<>(Map.of("the preview follows slider, values and selections, and goes",
			() -> new PreviewScenes().follows(), "Esc takes dialog and preview away",
			() -> new PreviewScenes().escape(), "the previewed image is closed meanwhile",
			() -> new PreviewScenes().closed(), "the preview is on the image that is chosen",
			() -> new PreviewScenes().twoImages(), "keys alone fill in the dialog",
			() -> new PreviewScenes().keys()));
	}

	private void follows() throws Exception {
		final ImagePlus image = DialogsMain.sample("preview");
		final Overlay mine = new Overlay(new Roi(2, 2, 3, 3));
		image.setOverlay(mine);
		final Dialog dialog = open();
		seen(dialog, image, 1);
		DialogsMain.require(image.getOverlay().contains(mine.get(0)), "The user's shape is gone.");
		image.setSlice(5);
		seen(dialog, image, 5);
		image.setRoi(new PointRoi(20.0, 24.0));
		final double automatic = area(image);
		Windows.type(dialog, "Threshold", "0.9");
		Windows.await("another mask", () -> area(image) > 0 && area(image) < automatic);
		toggle(dialog, "preview");
		Windows.await("no preview", () -> image.getOverlay() == mine);
		toggle(dialog, "preview");
		seen(dialog, image, 5);
		Windows.press(dialog, "Cancel");
		Windows.await("end", () -> image.getOverlay() == mine && !dialog.isShowing());
		for (final JComponent part : Windows.all(dialog, JComponent.class))
			if (part instanceof JButton || part instanceof JCheckBox)
				DialogsMain.require(part.getToolTipText() != null || part.getName() == null,
					part.getName() + " has no help.");
	}

	private void escape() throws Exception {
		final ImagePlus image = DialogsMain.sample("escape");
		final Dialog dialog = open();
		seen(dialog, image, 1);
		hand.focus(dialog, Windows.find(dialog, "frames"));
		hand.key(KeyEvent.VK_ESCAPE);
		Windows.await("end", () -> !dialog.isShowing() && image.getOverlay() == null);
		DialogsMain.require(DialogsMain.log().isEmpty(), DialogsMain.log());
	}

	private void closed() throws Exception {
		final ImagePlus image = DialogsMain.sample("closed meanwhile");
		final Dialog dialog = open();
		seen(dialog, image, 1);
		image.close();
		Windows.await("no words", () -> !Windows.text(dialog).contains("filament, width"));
		Windows.press(dialog, "OK");
		Windows.message("There is no image open");
	}

	private void twoImages() throws Exception {
		final ImagePlus other = DialogsMain.sample("other"), active = DialogsMain.sample("active");
		// The other window may be told late that it is active.
		hand.waitForIdle();
		WindowManager.setCurrentWindow(active.getWindow());
		final Dialog dialog = open();
		seen(dialog, active, 1);
		Windows.choose(dialog, "Image", "other");
		seen(dialog, other, 1);
		DialogsMain.require(active.getOverlay() == null, "The preview stays on the other image.");
		Windows.start(RESOLVE);
		Thread.sleep(300);
		DialogsMain.require(Windows.dialogs().count() == 1, "A second dialog is open.");
		Windows.press(dialog, "Cancel");
		Windows.await("end", () -> other.getOverlay() == null);
	}

	private void keys() throws Exception {
		final ImagePlus image = DialogsMain.sample("keys");
		final Dialog dialog = open();
		hand.focus(dialog, Windows.find(dialog, "frames"));
		hand.key(KeyEvent.VK_1);
		hand.key(KeyEvent.VK_MINUS);
		hand.key(KeyEvent.VK_3);
		Windows.await("text", () -> Windows.field(dialog, "Frames").getText().equals("1-3"));
		hand.key(KeyEvent.VK_A, KeyEvent.VK_ALT);
		Windows.await("advanced", () -> Windows.find(dialog, "threshold").isShowing());
		hand.key(KeyEvent.VK_ENTER);
		DialogsMain.finished();
		DialogsMain.require(image.getOverlay() != null, "Nothing came of it.");
	}

	private static Dialog open() throws Exception {
		Windows.start(RESOLVE);
		return Windows.dialog(RESOLVE);
	}

	/** The frame is described in words, and drawn. */
	private static void seen(final Dialog dialog, final ImagePlus image, final int frame)
		throws Exception {
		Windows.await("preview of frame " + frame,
			() -> Windows.text(dialog).contains("frame " + frame + ": 1 filament")
				&& area(image) > 0 && names(image).filter(r -> r.getName().equals("look-contour"))
					.allMatch(r -> r.getPosition() == frame));
	}

	private static Stream<Roi> names(final ImagePlus image) {
		return image.getOverlay() == null
			? Stream.empty()
			: Arrays.stream(image.getOverlay().toArray()).filter(r -> r.getName() != null);
	}

	/** Pixels inside the outline that is drawn. */
	private static double area(final ImagePlus image) {
		return names(image).filter(r -> r.getName().equals("look-mask"))
			.mapToDouble(r -> r.getStatistics().pixelCount).sum();
	}

	private void toggle(final Dialog dialog, final String name) throws Exception {
		final JCheckBox box = (JCheckBox) Windows.find(dialog, name);
		final boolean before = box.isSelected();
		hand.clickUntil(name + " to change", box, () -> box.isSelected() != before);
	}
}
