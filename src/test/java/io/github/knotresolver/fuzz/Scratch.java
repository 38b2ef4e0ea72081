package io.github.knotresolver.fuzz;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Comparator;
import java.util.stream.Stream;

/** A folder for drawn files. */
public final class Scratch {

	private final Path folder;

	/** Makes the folder; no display is needed from now on. */
	public Scratch() {
		System.setProperty("java.awt.headless", "true");
		try {
			folder = Files.createTempDirectory("knotresolver-fuzz-");
		} catch (final IOException e) {
			throw new UncheckedIOException(e);
		}
	}

	/** @return the folder */
	public Path path() {
		return folder;
	}

	/**
	 * @param name of the file
	 * @param bytes what is in it
	 * @return the file
	 */
	public Path write(final String name, final byte[] bytes) {
		try {
			return Files.write(folder.resolve(name), bytes);
		} catch (final IOException e) {
			throw new UncheckedIOException(e);
		}
	}

	/** Deletes all that is in it. */
	public void clear() {
		try (Stream<Path> all = Files.walk(folder)) {
			for (final Path file : all.sorted(Comparator.reverseOrder()).toList())
				if (!file.equals(folder))
					Files.delete(file);
		} catch (final IOException e) {
			throw new UncheckedIOException(e);
		}
	}

	/** Deletes the folder. */
	public void delete() {
		clear();
		folder.toFile().delete();
	}
}
