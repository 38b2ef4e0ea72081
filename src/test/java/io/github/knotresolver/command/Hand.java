package io.github.knotresolver.command;

import java.awt.AWTException;
import java.awt.Component;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.Robot;
import java.awt.event.InputEvent;
import java.io.File;
import java.io.IOException;
import java.util.concurrent.Callable;

import javax.imageio.ImageIO;

/** Mouse and keyboard, as a person uses them. */
final class Hand extends Robot {

	private static final long PATIENCE_MILLIS = 2000, STEP_MILLIS = 20;

	/** @param millis pause after each move, press and key */
	Hand(final int millis) throws AWTException {
		setAutoDelay(millis);
	}

	/** Where the mouse is. */
	void click() {
		mousePress(InputEvent.BUTTON1_DOWN_MASK);
		mouseRelease(InputEvent.BUTTON1_DOWN_MASK);
		waitForIdle();
	}

	void click(final int x, final int y) {
		mouseMove(x, y);
		click();
	}

	/** At shares of its width and height. */
	void click(final Component component, final double across, final double down) {
		final Point at = component.getLocationOnScreen();
		click(at.x + (int) (across * component.getWidth()),
			at.y + (int) (down * component.getHeight()));
	}

	/** In its middle, and again if it has moved from under the mouse: windows grow with their words. */
	void clickUntil(final String what, final Component component, final Callable<Boolean> done)
		throws Exception {
		Windows.await(what, () -> {
			click(component, 0.5, 0.5);
			final long end = System.currentTimeMillis() + PATIENCE_MILLIS;
			while (!done.call() && System.currentTimeMillis() < end)
				Thread.sleep(STEP_MILLIS);
			return done.call();
		});
	}

	/** Presses keys together; those named later are held for those named first. */
	void key(final int... keys) {
		for (int i = keys.length - 1; i >= 0; i--)
			keyPress(keys[i]);
		for (final int key : keys)
			keyRelease(key);
		waitForIdle();
	}

	/** What is on a part of the screen, as PNG. */
	void picture(final Rectangle part, final File file) throws IOException {
		waitForIdle();
		ImageIO.write(createScreenCapture(part), "png", file);
	}
}
