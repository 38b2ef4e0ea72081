package io.github.knotresolver.ui;

import java.awt.Dimension;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.Window;
import java.util.List;

import ij.gui.GUI;

/** Where windows stand. */
final class Beside {

	private Beside() {
	}

	/** Beside another window where there is room: right, below, left; else in the corner that is farthest. */
	static void place(final Window window, final Window other) {
		final Rectangle screen = GUI.getMaxWindowBounds(other), beside = other.getBounds();
		final Dimension size = window.getSize();
		final int lowest = screen.y + screen.height - size.height,
			rightmost = screen.x + screen.width - size.width;
		final int x = Math.max(screen.x, Math.min(rightmost, beside.x)),
			y = Math.max(screen.y, Math.min(lowest, beside.y));
		for (final Point corner : List.of(new Point(beside.x + beside.width, y),
			new Point(x, beside.y + beside.height), new Point(beside.x - size.width, y)))
			if (screen.contains(new Rectangle(corner, size))) {
				window.setLocation(corner);
				return;
			}
		window.setLocation(beside.x - screen.x > rightmost - beside.x ? screen.x : rightmost,
			Math.max(screen.y, lowest));
	}

	/** No larger than the screen, and inside it. */
	static void keepOnScreen(final Window window) {
		final Rectangle screen = GUI.getMaxWindowBounds(window);
		resize(window, Math.min(screen.width, window.getWidth()),
			Math.min(screen.height, window.getHeight()));
	}

	/** Of another size, moved as far as it would leave the screen. */
	static void resize(final Window window, final int width, final int height) {
		final Rectangle screen = GUI.getMaxWindowBounds(window);
		window.setBounds(
			Math.max(screen.x, Math.min(window.getX(), screen.x + screen.width - width)),
			Math.max(screen.y, Math.min(window.getY(), screen.y + screen.height - height)), width,
			height);
	}
}
