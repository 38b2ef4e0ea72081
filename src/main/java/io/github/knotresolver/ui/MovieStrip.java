package io.github.knotresolver.ui;

import java.util.function.IntSupplier;

import javax.swing.JComponent;

/** A movie from left to right, a column a frame. */
abstract class MovieStrip extends JComponent {

	private static final long serialVersionUID = 1L;

	private final transient IntSupplier frames;

	/** @param frames how many the movie has, at least 1 */
	MovieStrip(final IntSupplier frames) {
		this.frames = frames;
	}

	/** @return the frame at a place, from 1; beyond the ends, the nearest */
	final int frameAt(final int x) {
		final int n = frames.getAsInt();
		return Math.max(1, Math.min(n, 1 + x * n / Math.max(1, getWidth())));
	}

	/** @return where the column of a frame, from 1, begins; that after the last one ends the strip */
	final int left(final int frame) {
		return (int) ((long) (frame - 1) * getWidth() / frames.getAsInt());
	}
}
