package io.github.knotresolver.imagej;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;

import io.github.knotresolver.imagej.tiff.TiffImage;
import io.github.knotresolver.io.BatchRow;
import io.github.knotresolver.model.UserException;

/**
 * How much memory a movie takes while it is resolved, told from its file before it is read: enough to
 * decide how many may run at the same time.
 */
final class MovieMemory {

	/** What a run has beside the movie: tables, fits, pictures. */
	private static final long ALWAYS = 64L << 20;
	/**
	 * For a pixel of a frame: the movie, its light, its evidence; what is drawn is not kept. Rather too
	 * many, as is room for what only small movies notice.
	 */
	private static final long BYTES_A_PIXEL = 16;
	/** With so much, a movie of any length runs: what does not fit is left in its file. */
	private static final long ENOUGH = 8L << 30;
	/** How much smaller a film or a picture without losses is than its pixels, seldom more. */
	private static final long PACKED = 8;

	private MovieMemory() {
	}

	/**
	 * @param row a row of a batch
	 * @return bytes for its movie; those of an empty one if no file can have that name
	 */
	static long of(final BatchRow row) {
		try {
			return of(row.file());
		} catch (final UserException e) {
			// The row is refused when it has its turn.
			return ALWAYS;
		}
	}

	/**
	 * @param movie a movie's file, or a folder with one picture a frame
	 * @return bytes, rather too many than too few; those of an empty movie if the file cannot be read,
	 *         which is told when it has its turn
	 */
	static long of(final Path movie) {
		try {
			return Math.min(ENOUGH, ALWAYS + BYTES_A_PIXEL * pixels(movie));
		} catch (final IOException | UserException e) {
			return ALWAYS;
		}
	}

	private static long pixels(final Path movie) throws IOException {
		if (Files.isDirectory(movie)) {
			final List<Path> files;
			try (Stream<Path> inside = Files.list(movie)) {
				files = inside.filter(Files::isRegularFile).toList();
			}
			long sum = 0;
			for (final Path file : files)
				sum += PACKED * Files.size(file);
			return sum;
		}
		if (!Files.isRegularFile(movie))
			return 0;
		final long told = TiffImage.pixels(movie);
		return told > 0 ? told : PACKED * Files.size(movie);
	}
}
