package io.github.knotresolver.imagej.plot;

import java.awt.image.RenderedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.concurrent.ConcurrentSkipListMap;
import java.util.function.Supplier;

import javax.imageio.ImageIO;

import io.github.knotresolver.io.Failure;
import io.github.knotresolver.progress.CancelledException;

/**
 * Draws pictures into a folder, one by one. One that cannot be drawn, since it is
 * too large or memory is short, is left out with a note, and costs neither the
 * others nor the numbers. May be used by several threads.
 */
public final class Pictures {

	/** Draws into a file. */
	@FunctionalInterface
	public interface Drawing {

		/**
		 * @param file the file to write
		 * @throws IOException if it cannot be written
		 */
		void draw(Path file) throws IOException;
	}

	private final Path folder;
	private final Map<String, String> notes = new ConcurrentSkipListMap<>();

	/** @param folder an existing folder */
	public Pictures(final Path folder) {
		this.folder = folder;
	}

	/**
	 * @param name the file's name
	 * @param drawing draws it
	 * @throws IOException if the file cannot be written
	 * @throws CancelledException if the user asked to stop
	 */
	public void draw(final String name, final Drawing drawing) throws IOException {
		final Path file = folder.resolve(name);
		try {
			drawing.draw(file);
		} catch (final CancelledException e) {
			throw e;
		} catch (final RuntimeException | OutOfMemoryError e) {
			Files.deleteIfExists(file);
			notes.put(name, name + " was left out. " + reason(e));
		}
	}

	/**
	 * @param name the file's name
	 * @param picture draws it, to be written as PNG
	 * @throws IOException if the file cannot be written, or this Java has no PNG
	 * @throws CancelledException if the user asked to stop
	 */
	public void drawPng(final String name, final Supplier<? extends RenderedImage> picture)
		throws IOException {
		draw(name, file -> {
			if (!ImageIO.write(picture.get(), "png", file.toFile()))
				throw new IOException("This Java cannot write PNG pictures.");
		});
	}

	private static String reason(final Throwable e) {
		if (e instanceof NegativeArraySizeException || e instanceof IllegalArgumentException
			&& String.valueOf(e.getMessage()).contains("too large"))
			return "The picture would be larger than Java can draw.";
		return Failure.of(e, "give Java more").sentence();
	}

	/** @return what was left out and why, one sentence or two each, by the files' names */
	public List<String> notes() {
		return List.copyOf(notes.values());
	}
}
