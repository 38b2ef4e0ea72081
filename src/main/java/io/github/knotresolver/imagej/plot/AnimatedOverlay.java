package io.github.knotresolver.imagej.plot;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;

import ij.ImagePlus;
import ij.plugin.filter.AVI_Writer;
import io.github.knotresolver.model.UserException;

/** An overlay stack as a film that any player and slide show takes. */
public final class AnimatedOverlay {

	private static final int QUALITY = 85;

	private AnimatedOverlay() {
	}

	/**
	 * @param file the AVI file (JPEG frames) to write; replaced if it is there
	 * @param overlay an RGB stack
	 * @param framesPerSecond above 0 to 60
	 * @throws UserException if the speed is out of range
	 * @throws IOException if a file cannot be written
	 */
	public static void write(final Path file, final ImagePlus overlay, final double framesPerSecond)
		throws IOException {
		if (!(framesPerSecond > 0 && framesPerSecond <= 60))
			throw new UserException(
				"The speed must be above 0 and at most 60 frames per second, but is "
					+ framesPerSecond + ".");
		// The stack may be larger than memory, so it is not copied.
		final ImagePlus film = new ImagePlus(overlay.getTitle(), overlay.getStack());
		film.getCalibration().fps = framesPerSecond;
		Files.deleteIfExists(file);
		new AVI_Writer().writeImage(film, file.toString(), AVI_Writer.JPEG_COMPRESSION, QUALITY);
	}
}
