package io.github.knotresolver.command;

import java.awt.AWTException;
import java.awt.Component;
import java.awt.Container;
import java.awt.Image;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.Robot;
import java.awt.Window;
import java.awt.event.InputEvent;
import java.awt.image.RenderedImage;
import java.io.File;
import java.io.IOException;
import java.util.List;
import java.util.concurrent.Callable;

import javax.imageio.ImageIO;
import javax.swing.SwingUtilities;

/** Mouse and keyboard, as a person uses them. */
final class Hand extends Robot {

	private static final long PATIENCE_MILLIS = 2000, STEP_MILLIS = 20;

	/** @param millis pause after each move, press and key */
	Hand(final int millis) throws AWTException {
		setAutoDelay(millis);
	}

	/** Where the mouse is. */
	void click() {
		clicks(1);
	}

	/** With nothing waited for in between: a click that comes late is another one. */
	void doubleClick(final Component component, final double across, final double down)
		throws Exception {
		over(component, across, down);
		clicks(2);
	}

	private void clicks(final int number) {
		for (int i = 0; i < number; i++) {
			mousePress(InputEvent.BUTTON1_DOWN_MASK);
			mouseRelease(InputEvent.BUTTON1_DOWN_MASK);
		}
		waitForIdle();
	}

	void click(final int x, final int y) {
		mouseMove(x, y);
		click();
	}

	/** At shares of its width and height, once its window is in front and still. */
	void click(final Component component, final double across, final double down) throws Exception {
		over(component, across, down);
		click();
	}

	/** In its middle, and again if the click was lost: windows grow with their words. */
	void clickUntil(final String what, final Component component, final Callable<Boolean> done)
		throws Exception {
		until(what, () -> {
			if (component.isShowing())
				click(component, 0.5, 0.5);
		}, done);
	}

	/** Does what may be done twice, and again as long as nothing comes of it. */
	void until(final String what, final Step step, final Callable<Boolean> done) throws Exception {
		Windows.await(what, () -> {
			step.take();
			final long end = System.currentTimeMillis() + PATIENCE_MILLIS;
			while (!done.call() && System.currentTimeMillis() < end)
				Thread.sleep(STEP_MILLIS);
			return done.call();
		});
	}

	/** What a person does to a window. */
	interface Step {

		void take() throws Exception;
	}

	/** The mouse is moved until no other window lies between: nothing else orders windows here. */
	void over(final Component component, final double across, final double down) throws Exception {
		final Window window = component instanceof Window own
			? own
			: SwingUtilities.getWindowAncestor(component);
		Windows.await("the mouse over " + component, () -> {
			settle(window);
			final Point at = component.getLocationOnScreen();
			mouseMove(at.x + (int) (across * component.getWidth()),
				at.y + (int) (down * component.getHeight()));
			waitForIdle();
			final Point now = component.getLocationOnScreen();
			return now.equals(at) && (component instanceof Container inside
				? inside.getMousePosition(true)
				: component.getMousePosition()) != null;
		});
	}

	/**
	 * In front, and where Java believes it to be: without a window manager, the place in which a
	 * window was made can arrive after that to which it was moved, and stays believed until it moves
	 * again.
	 */
	private void settle(final Window window) throws Exception {
		final Point at = window.getLocation();
		for (final int aside : new int[]{1, 0}) {
			Windows.onEvents(() -> {
				window.toFront();
				window.setLocation(at.x + aside, at.y);
			});
			waitForIdle();
		}
	}

	/** Keys go there from now on. */
	void focus(final Window window, final Component inside) throws Exception {
		until("focus", () -> Windows.onEvents(() -> {
			window.toFront();
			inside.requestFocus();
		}), () -> window.isFocused() && (inside == window || inside.isFocusOwner()));
	}

	/** Presses keys together; those named later are held for those named first. */
	void key(final int... keys) {
		for (int i = keys.length - 1; i >= 0; i--)
			keyPress(keys[i]);
		for (final int key : keys)
			keyRelease(key);
		waitForIdle();
	}

	/** What is on a part of the screen, as PNG, in all pixels that the screen has. */
	void picture(final Rectangle part, final File file) throws IOException {
		waitForIdle();
		final List<Image> all = createMultiResolutionScreenCapture(part).getResolutionVariants();
		ImageIO.write((RenderedImage) all.get(all.size() - 1), "png", file);
	}
}
