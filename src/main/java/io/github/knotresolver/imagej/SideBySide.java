package io.github.knotresolver.imagej;

import java.awt.Color;
import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.image.BufferedImage;

import io.github.knotresolver.image.Pixels;
import io.github.knotresolver.model.Movie;

/**
 * Two movies in one picture, a row each, in the same grey values and at the same
 * scale: whoever looks sees whether they are alike.
 */
final class SideBySide {

	private static final int COLUMNS = 5, GAP = 6, TITLE = 22, MOST_WIDTH = 2400, LARGEST_SCALE = 3;

	private SideBySide() {
	}

	/** @return frames of both movies, spread over their time, the user's above */
	static BufferedImage of(final Movie yours, final Movie simulated) {
		final int columns = Math.min(COLUMNS, Math.min(yours.size(), simulated.size()));
		final int cell = Math.max(yours.width(), simulated.width());
		final int scale = Math.max(1, Math.min(LARGEST_SCALE, MOST_WIDTH / (cell * columns)));
		final BufferedImage picture = new BufferedImage(columns * (cell * scale + GAP) - GAP,
			2 * TITLE + scale * (yours.height() + simulated.height()) + GAP,
			BufferedImage.TYPE_INT_RGB);
		final Graphics2D graphics = picture.createGraphics();
		graphics.setColor(Color.WHITE);
		graphics.fillRect(0, 0, picture.getWidth(), picture.getHeight());
		final double[] range = range(yours);
		row(graphics, "yours", yours, 0, columns, cell, scale, range);
		row(graphics, "simulated", simulated, TITLE + yours.height() * scale + GAP, columns, cell,
			scale, range);
		graphics.dispose();
		return picture;
	}

	private static void row(final Graphics2D graphics, final String title, final Movie movie,
		final int top, final int columns, final int cell, final int scale, final double[] range) {
		graphics.setColor(Color.BLACK);
		graphics.setFont(new Font(Font.SANS_SERIF, Font.PLAIN, 15));
		for (int i = 0; i < columns; i++) {
			final int frame = columns == 1 ? 0 : i * (movie.size() - 1) / (columns - 1);
			final int left = i * (cell * scale + GAP);
			graphics.drawString(title + ", frame " + (frame + 1), left + 2, top + TITLE - 6);
			graphics.drawImage(grey(movie, frame, range), left, top + TITLE, movie.width() * scale,
				movie.height() * scale, null);
		}
	}

	private static BufferedImage grey(final Movie movie, final int frame, final double[] range) {
		final BufferedImage image = new BufferedImage(movie.width(), movie.height(),
			BufferedImage.TYPE_BYTE_GRAY);
		final double[] pixels = Pixels.doubles(movie.frame(frame));
		for (int i = 0; i < pixels.length; i++) {
			final double share = (pixels[i] - range[0]) / (range[1] - range[0]);
			final int grey = (int) Math.rint(255 * Math.max(0, Math.min(1, share)));
			image.getRaster().setSample(i % movie.width(), i / movie.width(), 0, grey);
		}
		return image;
	}

	private static double[] range(final Movie movie) {
		double low = Double.POSITIVE_INFINITY, high = Double.NEGATIVE_INFINITY;
		for (int t = 0; t < movie.size(); t++)
			for (final double v : Pixels.doubles(movie.frame(t))) {
				low = v < low ? v : low;
				high = v > high ? v : high;
			}
		return new double[]{low, Math.max(high, low + 1e-9)};
	}
}
