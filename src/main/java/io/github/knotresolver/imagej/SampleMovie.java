
package io.github.knotresolver.imagej;

import java.io.IOException;
import java.io.InputStream;

import ij.ImagePlus;
import ij.io.Opener;

/** The movie that comes with the program. */
public final class SampleMovie {

	/** Its name. */
	public static final String NAME = "knotted-filament.tif";

	private static final String RESOURCE = "/io/github/knotresolver/sample/" + NAME;

	private SampleMovie() {
	}

	/**
	 * @return the sample movie that comes with the program
	 * @throws IllegalStateException if it is missing from the jar
	 */
	public static ImagePlus open() {
		try (InputStream in = SampleMovie.class.getResourceAsStream(RESOURCE)) {
			if (in == null)
				throw new IllegalStateException(
					"The sample is missing from the program's jar; build it again.");
			return new Opener().openTiff(in, NAME);
		} catch (final IOException e) {
			throw new IllegalStateException("The sample cannot be read: " + e.getMessage() + ".",
				e);
		}
	}
}
