package io.github.knotresolver.ui;

import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.util.function.IntConsumer;

import javax.swing.JComponent;

/** Follows a mouse that is pressed, and dragged on. */
final class Dragging extends MouseAdapter {

	private final IntConsumer to;

	private Dragging(final IntConsumer to) {
		this.to = to;
	}

	/**
	 * @param part where the mouse is followed
	 * @param to hears how far from the left (pixels) it is
	 */
	static void in(final JComponent part, final IntConsumer to) {
		final Dragging dragging = new Dragging(to);
		part.addMouseListener(dragging);
		part.addMouseMotionListener(dragging);
	}

	@Override
	public void mousePressed(final MouseEvent e) {
		to.accept(e.getX());
	}

	@Override
	public void mouseDragged(final MouseEvent e) {
		to.accept(e.getX());
	}
}
