package io.github.knotresolver.imagej;

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
	 * @return it as a {@code data:} address, nearly as it is, in fewer bytes
	 * @throws IOException if this Java has no JPEG
	 */
	static String nearly(final BufferedImage picture) throws IOException {
		return address(picture, "jpeg");
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
