package io.github.knotresolver.ui;

import java.awt.Color;
import java.awt.Dimension;
import java.awt.FontMetrics;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.util.Locale;

import javax.swing.JComponent;

import io.github.knotresolver.ui.model.TuneModel;

/**
 * Brightness of the frame's pixels, on a logarithmic scale; the automatic threshold as a triangle, the
 * one that is set as a line, which the mouse drags.
 */
final class HistogramView extends JComponent {

	private static final long serialVersionUID = 1L;
	private static final Color GROUND = new Color(0x2b, 0x2b, 0x2b),
		BARS = new Color(0x9a, 0x9a, 0x9a), SET = new Color(0xf0, 0xe4, 0x42),
		AUTOMATIC = new Color(0x56, 0xb4, 0xe9);
	private static final String DARK = "0: dark", BRIGHT = "1: bright";
	private static final int GAP = 3;

	private final transient TuneModel model;

	HistogramView(final TuneModel model) {
		this.model = model;
		setName("histogram");
		setToolTipText(
			"Pixels by brightness (logarithmic); triangle: automatic; drag the line of the threshold");
		Dragging.in(this, this::set);
	}

	private void set(final int x) {
		final double at = Math.min(1, Math.max(0, x / (double) Math.max(1, getWidth())));
		model.set("threshold", String.format(Locale.ROOT, "%.2f", at));
	}

	@Override
	public Dimension getPreferredSize() {
		final int em = getFontMetrics(getFont()).getHeight();
		return new Dimension(30 * em, 5 * em);
	}

	@Override
	protected void paintComponent(final Graphics graphics) {
		final Graphics2D g = (Graphics2D) graphics.create();
		g.setColor(GROUND);
		g.fillRect(0, 0, getWidth(), getHeight());
		final int[] counts = model.histogram();
		int most = 1;
		for (final int count : counts)
			most = Math.max(most, count);
		g.setColor(BARS);
		for (int i = 0; i < counts.length; i++) {
			final int left = i * getWidth() / counts.length,
				right = (i + 1) * getWidth() / counts.length,
				height = (int) (getHeight() * Math.log1p(counts[i]) / Math.log1p(most));
			g.fillRect(left, getHeight() - height, right - left, height);
		}
		g.setColor(Color.WHITE);
		final FontMetrics words = g.getFontMetrics();
		g.drawString(DARK, GAP, GAP + words.getAscent());
		g.drawString(BRIGHT, getWidth() - GAP - words.stringWidth(BRIGHT), GAP + words.getAscent());
		model.automatic().ifPresent(t -> {
			final int x = (int) (t * getWidth()), size = Math.max(5, getHeight() / 8);
			g.setColor(AUTOMATIC);
			g.fillPolygon(new int[]{x - size, x + size, x}, new int[]{0, 0, 2 * size}, 3);
		});
		model.threshold().ifPresent(t -> {
			g.setColor(SET);
			g.fillRect((int) (t * getWidth()) - 1, 0, 3, getHeight());
		});
		g.dispose();
	}
}
