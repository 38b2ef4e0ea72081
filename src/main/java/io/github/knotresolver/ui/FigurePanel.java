package io.github.knotresolver.ui;

import java.awt.BorderLayout;
import java.awt.Cursor;
import java.awt.Dimension;
import java.awt.FlowLayout;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.awt.geom.Point2D;
import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.OptionalInt;
import java.util.function.Consumer;
import java.util.function.IntConsumer;

import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JFileChooser;
import javax.swing.JOptionPane;
import javax.swing.JPanel;
import javax.swing.ToolTipManager;

import io.github.knotresolver.imagej.plot.LiveFigure;

/** A figure as large as there is room; a click on it goes to the frame. */
final class FigurePanel extends JPanel {

	private static final long serialVersionUID = 1L;
	/** Of a figure, in letters' heights; a component has a WIDTH of its own. */
	private static final int BROAD = 42, HIGH = 17;

	private final transient LiveFigure figure;
	private final transient Consumer<String> say;
	private final Drawing drawing;
	private int frame;

	/**
	 * @param figure what is drawn
	 * @param goTo told the frame that is clicked
	 * @param say told what came of saving, one sentence
	 */
	FigurePanel(final LiveFigure figure, final IntConsumer goTo, final Consumer<String> say) {
		super(new BorderLayout());
		this.figure = figure;
		this.say = say;
		drawing = new Drawing(goTo);
		add(drawing, BorderLayout.CENTER);
		final JPanel buttons = new JPanel(new FlowLayout(FlowLayout.RIGHT, 4, 0));
		button(buttons, "Data", "The values as a table, or a kymograph as a 32-bit image",
			figure::showData);
		button(buttons, "In ImageJ", "As ImageJ's own plot or image, to restyle and measure",
			figure::showInImageJ);
		button(buttons, "Save...", "As a PNG or SVG file", this::save);
		add(buttons, BorderLayout.SOUTH);
		setName(figure.key());
	}

	private void button(final JPanel buttons, final String words, final String help,
		final Runnable action) {
		final JButton button = new JButton(words);
		button.setName(words + " " + figure.key());
		button.setToolTipText(help);
		button.addActionListener(e -> action.run());
		buttons.add(button);
	}

	/** Marks a frame. */
	void mark(final int shown) {
		frame = shown;
		drawing.repaint();
	}

	private void save() {
		final JFileChooser chooser = new JFileChooser();
		chooser.setDialogTitle("Save as PNG or SVG");
		chooser.setSelectedFile(new File(figure.key() + ".png"));
		if (chooser.showSaveDialog(this) != JFileChooser.APPROVE_OPTION)
			return;
		final Path file = chooser.getSelectedFile().toPath();
		if (Files.exists(file)
			&& JOptionPane.showConfirmDialog(this, "Replace " + file.getFileName() + "?", "Save",
				JOptionPane.YES_NO_OPTION) != JOptionPane.YES_OPTION)
			return;
		try {
			figure.save(file);
			say.accept("Saved as " + file + ".");
		} catch (final IOException e) {
			say.accept(file + " cannot be written: " + e.getMessage() + ".");
		}
	}

	/** The figure itself. */
	private final class Drawing extends JComponent {

		private static final long serialVersionUID = 1L;

		Drawing(final IntConsumer goTo) {
			setName("figure " + figure.key());
			ToolTipManager.sharedInstance().registerComponent(this);
			final MouseAdapter mouse = new MouseAdapter() {

				@Override
				public void mousePressed(final MouseEvent e) {
					frameAt(e).ifPresent(goTo);
				}

				@Override
				public void mouseMoved(final MouseEvent e) {
					setCursor(Cursor.getPredefinedCursor(
						frameAt(e).isPresent() ? Cursor.HAND_CURSOR : Cursor.DEFAULT_CURSOR));
				}
			};
			addMouseListener(mouse);
			addMouseMotionListener(mouse);
		}

		private OptionalInt frameAt(final MouseEvent e) {
			final double scale = GuiFont.factor();
			return figure.frameAt(new Point2D.Double(e.getX() / scale, e.getY() / scale));
		}

		@Override
		public Dimension getPreferredSize() {
			final int em = getFontMetrics(FigurePanel.this.getFont()).getHeight();
			return new Dimension(BROAD * em, HIGH * em);
		}

		@Override
		public String getToolTipText(final MouseEvent e) {
			final OptionalInt at = frameAt(e);
			return at.isPresent() ? "frame " + at.getAsInt() + ": click to see it" : null;
		}

		@Override
		protected void paintComponent(final Graphics g) {
			final Graphics2D own = (Graphics2D) g.create();
			// Its words grow with those around it.
			final double scale = GuiFont.factor();
			own.scale(scale, scale);
			figure.draw(own, (int) (getWidth() / scale), (int) (getHeight() / scale), frame);
			own.dispose();
		}
	}
}
