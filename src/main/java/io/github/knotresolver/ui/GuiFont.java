package io.github.knotresolver.ui;

import java.awt.Component;
import java.awt.Container;
import java.awt.Font;
import java.awt.Graphics;
import java.awt.Graphics2D;

import javax.swing.Icon;
import javax.swing.JCheckBox;
import javax.swing.JComponent;
import javax.swing.UIManager;

import ij.Prefs;

/**
 * Words as large as ImageJ's own ({@code Edit > Options > Appearance...}, GUI scale). ImageJ's
 * {@code GUI.scale} leaves Swing's parts as they are, for they can hold others.
 */
final class GuiFont {

	private static final String DONE = "knotresolver.scaled";

	private GuiFont() {
	}

	/** @return how much larger than usual ImageJ's words are */
	static double factor() {
		return Prefs.getGuiScale();
	}

	/**
	 * Enlarges all words, once; parts that were added since follow with the next call.
	 *
	 * @param part a window, or a part of one
	 */
	static void scale(final Component part) {
		if (factor() == 1)
			return;
		// Those inside first: who has no font of its own has that of what it lies in.
		if (part instanceof Container container)
			for (final Component inside : container.getComponents())
				scale(inside);
		final Font font = part.getFont();
		if (!(part instanceof JComponent own) || font == null
			|| own.getClientProperty(DONE) != null)
			return;
		own.putClientProperty(DONE, true);
		own.setFont(font.deriveFont((float) (font.getSize2D() * factor())));
		final Icon tick = UIManager.getIcon("CheckBox.icon");
		if (own instanceof JCheckBox box && box.getIcon() == null && tick != null)
			box.setIcon(new Enlarged(tick));
	}

	/** An icon in the size of the words beside it. */
	private record Enlarged(Icon icon) implements Icon {

		@Override
		public int getIconWidth() {
			return (int) (factor() * icon.getIconWidth());
		}

		@Override
		public int getIconHeight() {
			return (int) (factor() * icon.getIconHeight());
		}

		@Override
		public void paintIcon(final Component c, final Graphics g, final int x, final int y) {
			final Graphics2D own = (Graphics2D) g.create();
			own.translate(x, y);
			own.scale(factor(), factor());
			icon.paintIcon(c, own, 0, 0);
			own.dispose();
		}
	}
}
