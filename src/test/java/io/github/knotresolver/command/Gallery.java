package io.github.knotresolver.command;

import java.awt.Rectangle;
import java.awt.Window;
import java.io.File;
import java.util.Map;

/** Pictures of windows in a folder; if wanted, each window also smaller and larger than it opens. */
final class Gallery {

	private static final Map<String, Double> SIZES = Map.of("-smaller", 0.8, "-larger", 1.35);
	private static final int PAUSE = 600;

	private final Hand hand;
	private final File folder;
	private final boolean inSizes;

	/** @param inSizes whether windows are shown in other sizes, too */
	Gallery(final Hand hand, final File folder, final boolean inSizes) {
		this.hand = hand;
		this.folder = folder;
		this.inSizes = inSizes;
	}

	/** @return the file of this name */
	File file(final String name) {
		return new File(folder, name);
	}

	/** Takes a picture of a part of the screen. */
	void take(final String name, final Rectangle part) throws Exception {
		hand.waitForIdle();
		hand.delay(PAUSE);
		hand.picture(part, file(name));
	}

	/** The same, and the window that matters in other sizes. */
	void take(final String name, final Rectangle part, final Window window) throws Exception {
		take(name, part);
		if (!inSizes)
			return;
		final Rectangle before = window.getBounds();
		for (final Map.Entry<String, Double> size : SIZES.entrySet()) {
			Windows.onEvents(() -> window.setSize((int) (size.getValue() * before.width),
				(int) (size.getValue() * before.height)));
			take(name.replace(".png", size.getKey() + ".png"), window.getBounds());
		}
		Windows.onEvents(() -> window.setBounds(before));
		hand.waitForIdle();
	}
}
