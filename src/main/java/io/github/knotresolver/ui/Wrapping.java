package io.github.knotresolver.ui;

import java.awt.Component;
import java.awt.Container;
import java.awt.Dimension;
import java.awt.FlowLayout;
import java.awt.Insets;

/** Parts beside each other, in as many rows as the width asks for, all of which are seen. */
final class Wrapping extends FlowLayout {

	private static final long serialVersionUID = 1L;

	/**
	 * @param across room between parts (pixels)
	 * @param down likewise
	 */
	Wrapping(final int across, final int down) {
		super(LEFT, across, down);
	}

	/** Rows are counted anew once their width has changed. */
	static void countAnew(final Container part) {
		for (final Component inside : part.getComponents())
			if (inside instanceof Container container)
				countAnew(container);
		if (part.getLayout() instanceof Wrapping)
			part.invalidate();
	}

	@Override
	public Dimension preferredLayoutSize(final Container target) {
		synchronized (target.getTreeLock()) {
			final Insets edge = target.getInsets();
			final int most = target.getWidth() == 0
				? Integer.MAX_VALUE
				: target.getWidth() - edge.left - edge.right - getHgap();
			int widest = 0, height = getVgap(), across = getHgap(), row = 0;
			for (final Component part : target.getComponents()) {
				if (!part.isVisible())
					continue;
				final Dimension size = part.getPreferredSize();
				if (row > 0 && across + size.width > most) {
					height += row + getVgap();
					across = getHgap();
					row = 0;
				}
				across += size.width + getHgap();
				row = Math.max(row, size.height);
				widest = Math.max(widest, across);
			}
			return new Dimension(widest + edge.left + edge.right,
				height + row + getVgap() + edge.top + edge.bottom);
		}
	}

	@Override
	public Dimension minimumLayoutSize(final Container target) {
		return preferredLayoutSize(target);
	}
}
