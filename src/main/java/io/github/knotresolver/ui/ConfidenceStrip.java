package io.github.knotresolver.ui;

import java.awt.Color;
import java.awt.Dimension;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.Polygon;
import java.awt.RenderingHints;
import java.awt.event.MouseEvent;
import java.util.HashSet;
import java.util.Set;

import javax.swing.Timer;
import javax.swing.ToolTipManager;

import io.github.knotresolver.imagej.ReviewPictures;
import io.github.knotresolver.model.Observation;
import io.github.knotresolver.ui.model.ReviewModel;

/**
 * The whole movie at a glance: one column a frame, as high as its confidence. Doubtful frames have a
 * triangle above, checked ones a square below, frames without a contour a grey column with a bar
 * across. A click goes to the frame.
 */
final class ConfidenceStrip extends MovieStrip {

	private static final long serialVersionUID = 1L;
	private static final Color GROUND = new Color(0x2b, 0x2b, 0x2b),
		NONE = new Color(0x58, 0x58, 0x58), CHANGED = new Color(0x56, 0xb4, 0xe9),
		CHECKED = new Color(0x56, 0xb4, 0xe9), LIMIT = new Color(0xff, 0xff, 0xff, 0x80);

	/** A mark is no larger, however high the strip is. */
	private static final int MARK = 14;

	/** How long a change is seen to flash. */
	private static final int FLASHES = 12, FLASH_MILLIS = 80;

	private final transient ReviewModel model;
	private final Timer flash = new Timer(FLASH_MILLIS, e -> fade());
	private transient Set<Integer> flashed = Set.of();
	private int bright;

	ConfidenceStrip(final ReviewModel model) {
		super(() -> model.movie().size());
		this.model = model;
		Dragging.in(this, x -> model.goTo(frameAt(x)));
		setName("confidence");
		ToolTipManager.sharedInstance().registerComponent(this);
	}

	/** Shows what the model says now; frames that changed flash. */
	void refresh() {
		final Set<Integer> changed = model.changed();
		if (!changed.equals(flashed)) {
			flashed = changed;
			bright = changed.isEmpty() ? 0 : FLASHES;
			flash.start();
		}
		repaint();
	}

	private void fade() {
		if (--bright <= 0)
			flash.stop();
		repaint();
	}

	@Override
	public Dimension getPreferredSize() {
		final int em = getFontMetrics(getFont()).getHeight();
		return new Dimension(40 * em, 5 * em);
	}

	@Override
	public String getToolTipText(final MouseEvent e) {
		final int frame = frameAt(e.getX());
		final double confidence = model.confidences()[frame - 1];
		return "frame " + frame
			+ (Double.isNaN(confidence)
				? model.isLeftOut(frame) ? ": left out, or not in view" : ": no contour"
				: ": confidence " + ReviewWords.confidence(confidence));
	}

	@Override
	protected void paintComponent(final Graphics graphics) {
		final Graphics2D g = (Graphics2D) graphics.create();
		g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
		g.setColor(GROUND);
		g.fillRect(0, 0, getWidth(), getHeight());
		final double[] confidences = model.confidences();
		final Set<Integer> doubtful = new HashSet<>(model.doubtful()),
			changed = new HashSet<>(model.changed());
		final int mark = Math.max(6, Math.min(getHeight() / 8, MARK));
		for (int frame = 1; frame <= confidences.length; frame++) {
			final int left = left(frame), width = Math.max(1, left(frame + 1) - left);
			if (changed.contains(frame)) {
				g.setColor(mixed(CHANGED.darker().darker(), CHANGED, bright / (double) FLASHES));
				g.fillRect(left, 0, width, getHeight());
			}
			if (!model.isLeftOut(frame))
				paintColumn(g, confidences[frame - 1], left, width, mark);
			final int middle = left + width / 2;
			if (doubtful.contains(frame)) {
				g.setColor(Color.WHITE);
				g.fill(new Polygon(new int[]{middle - mark / 2, middle + mark / 2, middle},
					new int[]{1, 1, mark}, 3));
			}
			if (model.isChecked(frame)) {
				g.setColor(CHECKED);
				g.fillRect(middle - mark / 3, getHeight() - mark + 2, 2 * mark / 3, 2 * mark / 3);
			}
		}
		paintLimit(g, mark);
		paintPlace(g);
		g.dispose();
	}

	private void paintColumn(final Graphics2D g, final double confidence, final int left,
		final int width, final int mark) {
		final int room = getHeight() - 2 * mark - 2, gap = width > 4 ? 1 : 0;
		if (Double.isNaN(confidence)) {
			g.setColor(NONE);
			g.fillRect(left, mark + 1, width - gap, room);
			g.setColor(Color.WHITE);
			g.fillRect(left, mark + room / 2, width - gap, 2);
			return;
		}
		final int height = (int) Math.max(2, Math.rint(confidence * room));
		g.setColor(ReviewPictures.colour(confidence));
		g.fillRect(left, mark + 1 + room - height, width - gap, height);
	}

	/** From here on a contour is sure. */
	private void paintLimit(final Graphics2D g, final int mark) {
		final int room = getHeight() - 2 * mark - 2,
			y = mark + 1 + room - (int) Math.rint(Observation.SURE * room);
		g.setColor(LIMIT);
		g.drawLine(0, y, getWidth(), y);
	}

	private static Color mixed(final Color a, final Color b, final double share) {
		final double f = Math.max(0, Math.min(1, share));
		return new Color((int) (a.getRed() + f * (b.getRed() - a.getRed())),
			(int) (a.getGreen() + f * (b.getGreen() - a.getGreen())),
			(int) (a.getBlue() + f * (b.getBlue() - a.getBlue())));
	}

	private void paintPlace(final Graphics2D g) {
		final int left = left(model.frame()), width = Math.max(2, left(model.frame() + 1) - left);
		g.setColor(Color.BLACK);
		g.drawRect(left - 2, 0, width + 2, getHeight() - 1);
		g.setColor(Color.WHITE);
		g.drawRect(left - 1, 1, width, getHeight() - 3);
	}
}
