package io.github.knotresolver.ui;

import java.awt.Color;
import java.awt.Dimension;
import java.awt.Graphics;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.util.ArrayList;
import java.util.List;
import java.util.SortedSet;

import javax.swing.ToolTipManager;

import io.github.knotresolver.ui.model.ReviewModel;

/**
 * When the filament crosses which, below the strip of confidence: one row for each filament that it
 * crosses, itself first, with a mark in each such frame. A click goes to the frame.
 */
final class MeetingStrip extends MovieStrip {

	private static final long serialVersionUID = 1L;
	private static final int MOST_ROWS = 6;
	private static final Color GROUND = new Color(0x3a, 0x3a, 0x3a),
		SELF = new Color(0xd9, 0xd9, 0xd9), OTHER = new Color(0xe6, 0x9f, 0x00);

	private final transient ReviewModel model;

	MeetingStrip(final ReviewModel model) {
		super(() -> model.movie().size());
		this.model = model;
		setName("crossings");
		addMouseListener(new MouseAdapter() {

			@Override
			public void mousePressed(final MouseEvent e) {
				model.goTo(frameAt(e.getX()));
			}
		});
		ToolTipManager.sharedInstance().registerComponent(this);
	}

	/** Shows what the model says now. */
	void refresh() {
		revalidate();
		repaint();
	}

	private List<Integer> rows() {
		final List<Integer> rows = new ArrayList<>(model.meetings().keySet());
		if (rows.remove(Integer.valueOf(model.filament())))
			rows.add(0, model.filament());
		return rows.subList(0, Math.min(MOST_ROWS, rows.size()));
	}

	private int rowHeight() {
		return getFontMetrics(getFont()).getHeight();
	}

	@Override
	public Dimension getPreferredSize() {
		return new Dimension(1, rows().size() * rowHeight());
	}

	@Override
	public String getToolTipText(final MouseEvent e) {
		final int row = e.getY() / rowHeight();
		if (row >= rows().size())
			return null;
		final int other = rows().get(row), frame = frameAt(e.getX());
		return "frame " + frame
			+ (model.meetings().get(other).contains(frame) ? ": crosses " : ": does not cross ")
			+ name(other);
	}

	private String name(final int other) {
		return other == model.filament() ? "itself" : "filament " + other;
	}

	@Override
	protected void paintComponent(final Graphics g) {
		final int height = rowHeight();
		final List<Integer> rows = rows();
		for (int row = 0; row < rows.size(); row++) {
			g.setColor(GROUND);
			g.fillRect(0, row * height + 1, getWidth(), height - 1);
			final SortedSet<Integer> frames = model.meetings().get(rows.get(row));
			g.setColor(rows.get(row) == model.filament() ? SELF : OTHER);
			for (final int frame : frames)
				g.fillRect(left(frame), row * height + 2,
					Math.max(1, left(frame + 1) - left(frame) - 1), height - 3);
			paintName(g, name(rows.get(row)), row * height, height);
		}
	}

	private void paintName(final Graphics g, final String name, final int top, final int height) {
		g.setFont(getFont().deriveFont(height * 0.7f));
		final int width = g.getFontMetrics().stringWidth("x " + name);
		g.setColor(new Color(0, 0, 0, 170));
		g.fillRect(0, top + 1, width + 6, height - 1);
		g.setColor(Color.WHITE);
		g.drawString("x " + name, 3, top + height - 4);
	}
}
