package io.github.knotresolver.imagej;

import java.awt.image.RenderedImage;
import java.io.IOException;
import java.nio.file.Path;

import javax.imageio.ImageIO;

/** Writes pictures as PNG. */
final class PngFile {

	private PngFile() {
	}

	/**
	 * @param file the file to write
	 * @param picture the picture
	 * @throws IOException if it cannot be written, or this Java has no PNG
	 */
	static void write(final Path file, final RenderedImage picture) throws IOException {
		if (!ImageIO.write(picture, "png", file.toFile()))
			throw new IOException("This Java cannot write PNG pictures.");
	}
}
