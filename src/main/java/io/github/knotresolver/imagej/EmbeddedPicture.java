package io.github.knotresolver.imagej;

import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.util.Base64;

import javax.imageio.ImageIO;

/** Pictures inside a page: text that a browser shows without another file. */
final class EmbeddedPicture {

	private EmbeddedPicture() {
	}

	/**
	 * @param picture a picture
	 * @return it as a {@code data:} address, to the pixel
	 * @throws IOException if this Java has no PNG
	 */
	static String exact(final BufferedImage picture) throws IOException {
		return address(picture, "png");
	}

	/**
	 * @param picture a picture
	 * @param width most pixels across
	 * @return a smaller copy as a {@code data:} address
	 * @throws IOException if this Java has no JPEG
	 */
	static String small(final BufferedImage picture, final int width) throws IOException {
		final double scale = Math.min(1, (double) width / picture.getWidth());
		BufferedImage copy = picture;
		// Halving averages all pixels; a single step would leave most of them out.
		while (copy.getWidth() * 0.5 >= scale * picture.getWidth() && copy.getHeight() > 1)
			copy = scaled(copy, copy.getWidth() / 2, copy.getHeight() / 2);
		return address(scaled(copy, Math.max(1, (int) Math.rint(scale * picture.getWidth())),
			Math.max(1, (int) Math.rint(scale * picture.getHeight()))), "jpeg");
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

	private static String address(final BufferedImage picture, final String kind)
		throws IOException {
		final ByteArrayOutputStream bytes = new ByteArrayOutputStream();
		if (!ImageIO.write(picture, kind, bytes))
			throw new IOException("This Java cannot write " + kind + " pictures.");
		return "data:image/" + kind + ";base64,"
			+ Base64.getEncoder().encodeToString(bytes.toByteArray());
	}
}
