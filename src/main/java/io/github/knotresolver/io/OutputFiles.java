package io.github.knotresolver.io;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.util.Collection;
import java.util.List;
import java.util.function.Predicate;

import io.github.knotresolver.model.UserException;

/**
 * A file that a user names, with others beside it: each is complete or absent,
 * and none of the user's is overwritten unasked. They are written into a hidden
 * folder and moved to their places at the end.
 */
public final class OutputFiles implements AutoCloseable {

	private final Path folder;
	private final List<String> names;
	private final boolean overwrite;
	private final FolderLock lock;
	private final Path workplace;

	private OutputFiles(final HiddenNames hidden, final List<String> names, final boolean overwrite,
		final FolderLock lock) throws IOException {
		this.folder = hidden.base();
		this.names = names;
		this.overwrite = overwrite;
		this.lock = lock;
		this.workplace = Files.createDirectory(hidden.fresh(HiddenNames.PARTIAL));
	}

	/**
	 * Reserves the places.
	 *
	 * @param out the file that the user names
	 * @param others names of the files beside it
	 * @param isOurs whether a file at {@code out} is one that this program wrote
	 * @param overwrite whether earlier ones may be replaced
	 * @param inputs files that are read meanwhile; they are never replaced
	 * @return the files, to be written, committed and closed
	 * @throws UserException if they may not be written, in one sentence
	 * @throws IOException if the hidden folder cannot be made
	 */
	public static OutputFiles reserve(final Path out, final List<String> others,
		final Predicate<Path> isOurs, final boolean overwrite, final Collection<Path> inputs)
		throws IOException {
		final Path file = out.toAbsolutePath().normalize();
		requirePlace(out, file);
		final HiddenNames hidden = HiddenNames.of(file.getParent().toRealPath(), file);
		final FolderLock lock = FolderLock.acquire(hidden.lock())
			.orElseThrow(() -> new UserException("out " + out
				+ " is being written by another run; wait for it, or choose another file."));
		try {
			Leftovers.clear(hidden, file);
			requireFree(out, isOurs, overwrite, inputs);
			for (final String other : others)
				requireFree(file.resolveSibling(other), f -> true, overwrite, inputs);
			return new OutputFiles(hidden, List.copyOf(others), overwrite, lock);
		} catch (final IOException | RuntimeException e) {
			lock.close();
			throw e;
		}
	}

	private static void requirePlace(final Path out, final Path file) {
		final Path folder = file.getParent();
		if (folder == null || Files.isDirectory(file) || !Files.isDirectory(folder)
			|| !Files.isWritable(folder))
			throw new UserException(
				"out " + out + " cannot be written; choose a file in a writable folder.");
		if (ResultPlace.isTooLong(file))
			throw new UserException(
				"out " + out + " is longer than the file system allows; choose a shorter name.");
	}

	private static void requireFree(final Path out, final Predicate<Path> isOurs,
		final boolean overwrite, final Collection<Path> inputs) throws IOException {
		if (!Files.exists(out, LinkOption.NOFOLLOW_LINKS))
			return;
		for (final Path input : inputs)
			if (Files.exists(input) && Files.exists(out) && Files.isSameFile(input, out))
				throw new UserException(
					"out " + out + " is a file that is read; choose another one.");
		if (!Files.isRegularFile(out) || !isOurs.test(out))
			throw new UserException("out " + out
				+ " is there already and was not written by this program; choose another file.");
		if (!overwrite)
			throw new UserException("out " + out
				+ " is there already; choose another file, or add force to replace it.");
	}

	/** @return the folder to write the files into, under their own names */
	public Path path() {
		return workplace;
	}

	/**
	 * Moves all files to their places, the first one that the user named first.
	 *
	 * @param out the name of that file
	 * @throws IOException if one cannot be moved
	 */
	public void commit(final String out) throws IOException {
		move(out);
		for (final String name : names)
			if (Files.exists(workplace.resolve(name)))
				move(name);
	}

	private void move(final String name) throws IOException {
		final Path target = folder.resolve(name);
		if (!overwrite && Files.exists(target, LinkOption.NOFOLLOW_LINKS))
			throw new IOException(
				"another program has written to " + target + " meanwhile; choose another file");
		FileTrees.replace(workplace.resolve(name), target);
	}

	/** Removes what was not committed. */
	@Override
	public void close() throws IOException {
		try {
			FileTrees.delete(workplace);
		} finally {
			lock.close();
		}
	}
}
