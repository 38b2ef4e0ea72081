package io.github.knotresolver.ui;

import java.awt.Color;
import java.awt.Dimension;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.event.MouseEvent;

import javax.swing.ToolTipManager;

import io.github.knotresolver.ui.model.TuneModel;

/**
 * The whole movie at a glance: one column a frame, as high as its mask is large. One object is grey,
 * several are orange with a white mark above, a frame without any has a cross. A click goes there.
 */
final class FrameStrip extends MovieStrip {

	private static final long serialVersionUID = 1L;
	private static final Color GROUND = new Color(0x2b, 0x2b, 0x2b),
		ONE = new Color(0xb0, 0xb0, 0xb0), SEVERAL = new Color(0xe6, 0x9f, 0x00),
		UNKNOWN = new Color(0x45, 0x45, 0x45);

	private final transient TuneModel model;

	FrameStrip(final TuneModel model) {
		super(() -> model.movie().size());
		this.model = model;
		setName("strip");
		ToolTipManager.sharedInstance().registerComponent(this);
		Dragging.in(this, x -> model.goTo(frameAt(x)));
	}

	@Override
	public String getToolTipText(final MouseEvent e) {
		final int frame = frameAt(e.getX()), objects = model.objects()[frame - 1];
		return "frame " + frame
			+ (objects < 0
				? ": not looked at yet"
				: ": " + objects + (objects == 1 ? " object, " : " objects, ")
					+ model.areas()[frame - 1] + " px");
	}

	@Override
	public Dimension getPreferredSize() {
		final int em = getFontMetrics(getFont()).getHeight();
		return new Dimension(30 * em, 4 * em);
	}

	@Override
	protected void paintComponent(final Graphics graphics) {
		final Graphics2D g = (Graphics2D) graphics.create();
		g.setColor(GROUND);
		g.fillRect(0, 0, getWidth(), getHeight());
		final int[] objects = model.objects(), areas = model.areas();
		int most = 1;
		for (final int area : areas)
			most = Math.max(most, area);
		final int mark = Math.max(5, getHeight() / 8), room = getHeight() - mark - 1;
		for (int t = 0; t < objects.length; t++) {
			final int left = left(t + 1), width = Math.max(1, left(t + 2) - left),
				gap = width > 4 ? 1 : 0,
				height = Math.max(1, (int) ((long) room * areas[t] / most));
			g.setColor(objects[t] < 0 ? UNKNOWN : objects[t] > 1 ? SEVERAL : ONE);
			if (objects[t] == 0) {
				g.setColor(Color.WHITE);
				g.drawLine(left, mark, left + width - gap, getHeight() - 1);
				g.drawLine(left, getHeight() - 1, left + width - gap, mark);
			} else
				g.fillRect(left, objects[t] < 0 ? getHeight() - 2 : getHeight() - height,
					width - gap, height);
			if (objects[t] > 1) {
				g.setColor(Color.WHITE);
				g.fillRect(left, 0, width - gap, mark - 2);
			}
		}
		final int left = left(model.frame()), width = Math.max(3, left(model.frame() + 1) - left);
		g.setColor(Color.BLACK);
		g.drawRect(left + 1, 1, width - 2, getHeight() - 3);
		g.setColor(Color.WHITE);
		g.drawRect(left, 0, width, getHeight() - 1);
		g.dispose();
	}
}
