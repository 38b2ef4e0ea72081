package io.github.knotresolver.imagej;

import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.image.BufferedImage;

import io.github.knotresolver.model.Observation;
import io.github.knotresolver.model.Tracks;

/**
 * All frames of a result in one picture to judge at a glance: each frame with
 * its contour in colour along the length, its number, and a border in the colour
 * of its status. Of long movies, evenly chosen frames.
 */
public final class Montage {

	/** Most frames in one picture. */
	static final int MOST_FRAMES = 48;

	private static final int WIDTH = 1920, BORDER = 3, GAP = 2, MOST_COLUMNS = 8, BRIGHTEST = 150;
	private static final double LARGEST_SCALE = 4, LINE = 2, RING = 4;
	private static final int DOT = 2;

	private Montage() {
	}

	/**
	 * @param tracks a result
	 * @return the picture, at most {@value #WIDTH} pixels wide
	 */
	public static BufferedImage of(final Tracks tracks) {
		final int[] chosen = chosen(tracks.movie().size());
		final int columns = columns(chosen.length);
		final int rows = (chosen.length + columns - 1) / columns;
		final Viewport part = Viewport.aroundContours(tracks);
		final double room = (double) WIDTH / columns - GAP - 2 * BORDER;
		final Viewport view = part.scaled(Math.min(LARGEST_SCALE, room / part.width()));
		final int cellWidth = view.screenWidth() + 2 * BORDER + GAP,
			cellHeight = view.screenHeight() + 2 * BORDER + GAP;
		final BufferedImage montage = new BufferedImage(columns * cellWidth, rows * cellHeight,
			BufferedImage.TYPE_INT_RGB);
		final FramePainter painter = new FramePainter(Contrast.of(tracks.movie(), BRIGHTEST),
			view);
		final Graphics2D g = montage.createGraphics();
		for (int i = 0; i < chosen.length; i++)
			drawCell(g, tracks, chosen[i], painter, i % columns * cellWidth,
				i / columns * cellHeight);
		g.dispose();
		return montage;
	}

	private static void drawCell(final Graphics2D g, final Tracks tracks, final int index,
		final FramePainter painter, final int left, final int top) {
		final Observation frame = tracks.only().frames().get(index);
		final BufferedImage picture = painter.paint(tracks.movie().frame(index));
		frame.contour().ifPresent(c -> {
			painter.draw(picture, c, LINE, 1);
			painter.mark(picture, c.first(), RING);
		});
		g.setColor(Palette.of(frame.status()));
		g.fillRect(left, top, picture.getWidth() + 2 * BORDER, picture.getHeight() + 2 * BORDER);
		g.drawImage(picture, left + BORDER, top + BORDER, null);
		Digits.draw(g, frame.frame(), left + BORDER + 2 * DOT, top + BORDER + 2 * DOT, DOT,
			Color.WHITE);
	}

	/** 0-based indices, evenly spread, first and last among them. */
	static int[] chosen(final int frames) {
		final int n = Math.min(frames, MOST_FRAMES);
		final int[] indices = new int[n];
		for (int i = 0; i < n; i++)
			indices[i] = n == 1 ? 0 : (int) Math.rint((double) i * (frames - 1) / (n - 1));
		return indices;
	}

	private static int columns(final int cells) {
		return Math.min(MOST_COLUMNS, (int) Math.ceil(Math.sqrt(cells * 1.4)));
	}
}
