package io.github.knotresolver.imagej;

import java.awt.Color;
import java.awt.Graphics2D;

/**
 * Numbers drawn from dots, so that pictures need no font and are the same on
 * every machine.
 */
final class Digits {

	static final int HEIGHT = 5;
	private static final int WIDTH = 3;

	/** Rows of three dots from the top, one digit an entry. */
	private static final String[] DOTS = {"###|#.#|#.#|#.#|###", ".#.|##.|.#.|.#.|###",
		"###|..#|###|#..|###", "###|..#|.##|..#|###", "#.#|#.#|###|..#|..#", "###|#..|###|..#|###",
		"###|#..|###|#.#|###", "###|..#|..#|.#.|.#.", "###|#.#|###|#.#|###", "###|#.#|###|..#|###"};

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
