
package io.github.knotresolver.imagej;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Path;

import ij.ImagePlus;
import ij.io.Opener;
import io.github.knotresolver.image.Movie;
import io.github.knotresolver.io.InputOptions;

/** Files become movies. */
public final class MovieLoader {

	/** Name of the movie that comes with the program. */
	public static final String SAMPLE = "knotted-filament.tif";

	private static final String SAMPLE_RESOURCE = "/io/github/knotresolver/sample/" + SAMPLE;

	private MovieLoader() {
	}

	/**
	 * @param file an image file that plain ImageJ reads
	 * @param options channel, axis of time and calibration
	 * @return the movie
	 * @throws IllegalArgumentException if it cannot be used, in one sentence
	 */
	public static Movie load(final Path file, final InputOptions options) {
		return ImageMovie.of(ImageFile.open(file), options);
	}

	/**
	 * @return the sample movie that comes with the program
	 * @throws IllegalStateException if it is missing from the jar
	 */
	public static ImagePlus sample() {
		try (InputStream in = MovieLoader.class.getResourceAsStream(SAMPLE_RESOURCE)) {
			if (in == null)
				throw new IllegalStateException(
					"The sample is missing from the program's jar; build it again.");
			return new Opener().openTiff(in, SAMPLE);
		} catch (final IOException e) {
			throw new IllegalStateException("The sample cannot be read: " + e.getMessage() + ".",
				e);
		}
	}
}
