package io.github.knotresolver.imagej;

import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.Point;
import java.awt.image.BufferedImage;
import java.util.EnumSet;
import java.util.List;
import java.util.Set;

import io.github.knotresolver.image.Contrast;
import io.github.knotresolver.model.FilamentTrack;
import io.github.knotresolver.model.FrameStatus;
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
	private static final List<FrameStatus> WORST_FIRST = List.of(FrameStatus.UNRESOLVED,
		FrameStatus.LOST, FrameStatus.RESOLVED, FrameStatus.CORRECTED, FrameStatus.IGNORED,
		FrameStatus.ABSENT);

	private Montage() {
	}

	/**
	 * @param tracks a result
	 * @return the picture, at most {@value #WIDTH} pixels wide
	 */
	public static BufferedImage of(final Tracks tracks) {
		return of(tracks, tracks.filaments());
	}

	/**
	 * @param tracks a result
	 * @param filaments those of its filaments that are shown
	 * @return the picture of the part of the image in which they are
	 */
	public static BufferedImage of(final Tracks tracks, final List<FilamentTrack> filaments) {
		final int[] chosen = chosen(tracks.movie().size());
		final int columns = columns(chosen.length);
		final int rows = (chosen.length + columns - 1) / columns;
		final Viewport part = Viewport.aroundContours(tracks.movie(), filaments);
		final double room = (double) WIDTH / columns - GAP - 2 * BORDER;
		final Viewport view = part.scaled(Math.min(LARGEST_SCALE, room / part.width()));
		final int cellWidth = view.screenWidth() + 2 * BORDER + GAP,
			cellHeight = view.screenHeight() + 2 * BORDER + GAP;
		final BufferedImage montage = new BufferedImage(columns * cellWidth, rows * cellHeight,
			BufferedImage.TYPE_INT_RGB);
		final ContourPainter painter = new ContourPainter(tracks, filaments,
			new FramePainter(Contrast.of(tracks.movie(), BRIGHTEST), view), LINE, RING);
		final Graphics2D g = montage.createGraphics();
		for (int i = 0; i < chosen.length; i++) {
			g.setColor(Palette.of(worst(filaments, chosen[i])));
			drawCell(g, painter.paint(chosen[i]), chosen[i] + 1,
				new Point(i % columns * cellWidth, i / columns * cellHeight));
		}
		g.dispose();
		return montage;
	}

	private static void drawCell(final Graphics2D g, final BufferedImage picture, final int frame,
		final Point corner) {
		g.fillRect(corner.x, corner.y, picture.getWidth() + 2 * BORDER,
			picture.getHeight() + 2 * BORDER);
		g.drawImage(picture, corner.x + BORDER, corner.y + BORDER, null);
		Digits.draw(g, frame, corner.x + BORDER + 2 * DOT, corner.y + BORDER + 2 * DOT, DOT,
			Color.WHITE);
	}

	/** The border tells the filament that most needs a look. */
	private static FrameStatus worst(final List<FilamentTrack> filaments, final int index) {
		final Set<FrameStatus> present = EnumSet.noneOf(FrameStatus.class);
		filaments.forEach(f -> present.add(f.frames().get(index).status()));
		return WORST_FIRST.stream().filter(present::contains).findFirst()
			.orElse(FrameStatus.ABSENT);
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

	/**
	 * Numbers drawn from dots, so that pictures need no font and are the same on
	 * every machine.
	 */
	private static final class Digits {

		static final int HEIGHT = 5;
		private static final int WIDTH = 3;

		/** Rows of three dots from the top, one digit an entry. */
		private static final String[] DOTS = {"###|#.#|#.#|#.#|###", ".#.|##.|.#.|.#.|###",
			"###|..#|###|#..|###", "###|..#|.##|..#|###", "#.#|#.#|###|..#|..#",
			"###|#..|###|..#|###", "###|#..|###|#.#|###", "###|..#|..#|.#.|.#.",
			"###|#.#|###|#.#|###", "###|#.#|###|..#|###"};

		private Digits() {
		}

		/**
		 * @param g where to draw
		 * @param number 0 or more
		 * @param left left edge
		 * @param top upper edge
		 * @param dot edge of a dot
		 * @param color of the dots
		 */
		static void draw(final Graphics2D g, final int number, final int left, final int top,
			final int dot, final Color color) {
			g.setColor(color);
			final String digits = Integer.toString(number);
			for (int d = 0; d < digits.length(); d++) {
				final String[] rows = DOTS[digits.charAt(d) - '0'].split("\\|");
				for (int y = 0; y < HEIGHT; y++)
					for (int x = 0; x < WIDTH; x++)
						if (rows[y].charAt(x) == '#')
							g.fillRect(left + (d * (WIDTH + 1) + x) * dot, top + y * dot, dot, dot);
			}
		}
	}
}
