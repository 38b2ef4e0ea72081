package io.github.knotresolver.imagej;

import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;

import javax.imageio.ImageIO;

/** Pictures of results, made smaller for a list of many. */
public final class SmallPicture {

	private SmallPicture() {
	}

	/**
	 * @param file a picture of a result
	 * @param width most pixels across
	 * @return a smaller copy; empty if it is not there, damaged, or too large to be read
	 */
	public static Optional<BufferedImage> read(final Path file, final int width) {
		if (!Files.isRegularFile(file))
			return Optional.empty();
		try {
			return Optional.ofNullable(ImageIO.read(file.toFile())).map(p -> of(p, width));
		} catch (final IOException | OutOfMemoryError e) {
			return Optional.empty();
		}
	}

	/** A copy of at most so many pixels across. */
	private static BufferedImage of(final BufferedImage picture, final int width) {
		final double scale = Math.min(1, (double) width / picture.getWidth());
		BufferedImage copy = picture;
		// Halving averages all pixels; a single step would leave most of them out.
		while (copy.getWidth() * 0.5 >= scale * picture.getWidth() && copy.getHeight() > 1)
			copy = scaled(copy, copy.getWidth() / 2, copy.getHeight() / 2);
		return scaled(copy, Math.max(1, (int) Math.rint(scale * picture.getWidth())),
			Math.max(1, (int) Math.rint(scale * picture.getHeight())));
	}

	private static BufferedImage scaled(final BufferedImage picture, final int width,
		final int height) {
		final BufferedImage copy = new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB);
		final Graphics2D g = copy.createGraphics();
		g.setRenderingHint(RenderingHints.KEY_INTERPOLATION,
			RenderingHints.VALUE_INTERPOLATION_BILINEAR);
		g.drawImage(picture, 0, 0, width, height, null);
		g.dispose();
		return copy;
	}
}
