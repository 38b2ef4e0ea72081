package io.github.knotresolver.ui;

import java.awt.Color;
import java.awt.Component;
import java.awt.Cursor;
import java.awt.Graphics;
import java.awt.GraphicsConfiguration;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.awt.image.BufferedImage;
import java.util.Optional;
import java.util.function.Consumer;

import javax.swing.BorderFactory;
import javax.swing.Icon;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.SwingConstants;

import io.github.knotresolver.geometry.Polyline;

/** A row of small pictures with words below, to be hovered over and clicked. */
final class Thumbnails extends JPanel {

	private static final long serialVersionUID = 1L;
	private static final Color FRAME = new Color(0x00, 0x72, 0xb2);

	/**
	 * One picture.
	 *
	 * @param name of the component
	 * @param words below it
	 * @param help what it is, and what a click does
	 * @param picture it, in pixels of the screen
	 * @param marked whether it is the present one
	 * @param contour what is drawn on the image while the mouse is over it
	 * @param click what a click does
	 */
	record Item(String name, String words, String help, BufferedImage picture, boolean marked,
		Optional<Polyline> contour, Runnable click) {
	}

	private final transient Consumer<Optional<Polyline>> hover;

	/** @param hover told the contour of the picture that the mouse is over */
	Thumbnails(final Consumer<Optional<Polyline>> hover) {
		super(new Wrapping(4, 2));
		this.hover = hover;
	}

	/** @return pixels of the screen for a pixel of this window */
	double sharpness() {
		final GraphicsConfiguration screen = getGraphicsConfiguration();
		return screen == null ? 1 : screen.getDefaultTransform().getScaleX();
	}

	/** Shows other pictures. */
	void show(final Iterable<Item> items) {
		removeAll();
		items.forEach(this::add);
		GuiFont.scale(this);
		revalidate();
		repaint();
	}

	private void add(final Item item) {
		final JLabel label = new JLabel(item.words, new Sharp(item.picture, sharpness()),
			SwingConstants.CENTER);
		label.setName(item.name);
		label.setToolTipText(item.help);
		label.setVerticalTextPosition(SwingConstants.BOTTOM);
		label.setHorizontalTextPosition(SwingConstants.CENTER);
		label.setBorder(BorderFactory.createLineBorder(item.marked ? FRAME : getBackground(), 2));
		label.setCursor(Cursor.getPredefinedCursor(Cursor.HAND_CURSOR));
		label.addMouseListener(new MouseAdapter() {

			@Override
			public void mouseEntered(final MouseEvent e) {
				hover.accept(item.contour);
			}

			@Override
			public void mouseExited(final MouseEvent e) {
				hover.accept(Optional.empty());
			}

			@Override
			public void mousePressed(final MouseEvent e) {
				item.click.run();
			}
		});
		add(label);
	}

	/** A picture that has all pixels of the screen, also where the window has fewer. */
	private record Sharp(BufferedImage picture, double sharpness) implements Icon {

		@Override
		public int getIconWidth() {
			return (int) Math.rint(picture.getWidth() / sharpness);
		}

		@Override
		public int getIconHeight() {
			return (int) Math.rint(picture.getHeight() / sharpness);
		}

		@Override
		public void paintIcon(final Component c, final Graphics g, final int x, final int y) {
			g.drawImage(picture, x, y, getIconWidth(), getIconHeight(), null);
		}
	}
}
