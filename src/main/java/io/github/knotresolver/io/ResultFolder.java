
package io.github.knotresolver.io;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.AtomicMoveNotSupportedException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.Comparator;
import java.util.List;
import java.util.stream.Stream;

import io.github.knotresolver.model.UserException;

/**
 * A folder of results that is complete or absent: files are written into a
 * hidden folder beside it, which takes the wanted name at the end.
 *
 * <pre>
 * try (ResultFolder folder = ResultFolder.prepare(out, false)) {
 * 	write(folder.path());
 * 	folder.commit();
 * }
 * </pre>
 *
 * Closing without {@link #commit()} removes everything that was written.
 */
public final class ResultFolder implements AutoCloseable {

	private final Path target;
	private final Path workplace;
	private boolean committed;

	private ResultFolder(final Path target, final Path workplace) {
		this.target = target;
		this.workplace = workplace;
	}

	/**
	 * Checks that a result may be written, without writing anything.
	 *
	 * @param out the wanted folder; it may be absent or empty
	 * @param overwrite whether an earlier result may be replaced, with all that
	 *          is in its folder; a folder without a result never is
	 * @throws UserException if it may not, in one sentence
	 */
	public static void check(final Path out, final boolean overwrite) {
		final Path target = out.toAbsolutePath().normalize();
		final Path parent = existingParent(target);
		if (!Files.isDirectory(parent))
			throw new UserException("out " + out + " cannot be written, because "
				+ parent + " is a file; choose another folder.");
		if (Files.exists(target))
			checkExisting(out, target, overwrite);
		else if (!Files.isWritable(parent))
			throw new UserException(
				"out " + out + " cannot be written, because the folder " + parent
					+ " is not writable; choose another one.");
	}

	private static void checkExisting(final Path out, final Path target, final boolean overwrite) {
		if (!Files.isDirectory(target))
			throw new UserException(
				"out " + out + " is a file, but the result needs a folder; choose another name.");
		if (!Files.isWritable(target) || !Files.isWritable(target.getParent()))
			throw new UserException(
				"out " + out + " is a folder that is not writable; choose another one.");
		if (isEmpty(target))
			return;
		if (!isResult(target))
			throw new UserException("out " + out
				+ " holds files that are not a result of this program; choose another one.");
		if (!overwrite)
			throw new UserException("out " + out
				+ " already holds a result; choose another one, or add --force to replace it.");
	}

	/**
	 * Opens a folder for writing.
	 *
	 * @param out the wanted folder; missing parents are made at the end
	 * @param overwrite whether an earlier result may be replaced
	 * @return the folder, to be committed and closed
	 * @throws UserException if it may not be written, in one sentence
	 * @throws IOException if the disk says no
	 */
	public static ResultFolder prepare(final Path out, final boolean overwrite) throws IOException {
		check(out, overwrite);
		final Path target = Files.exists(out) ? out.toRealPath() : out.toAbsolutePath().normalize();
		final Path workplace = hidden(existingParent(target), target, "partial");
		return new ResultFolder(target, Files.createDirectory(workplace));
	}

	/** @return where the files are written until {@link #commit()} */
	public Path path() {
		return workplace;
	}

	/**
	 * Gives the folder its name; an earlier result is replaced.
	 *
	 * @throws IOException if the disk says no; the earlier result is kept then
	 */
	public void commit() throws IOException {
		Files.createDirectories(target.getParent());
		if (!Files.exists(target))
			move(workplace, target);
		else
			replace();
		committed = true;
	}

	private void replace() throws IOException {
		final Path old = hidden(target.getParent(), target, "old");
		move(target, old);
		try {
			move(workplace, target);
		} catch (final IOException e) {
			move(old, target);
			throw e;
		}
		delete(old);
	}

	/** Removes what was written, unless it was committed. */
	@Override
	public void close() throws IOException {
		if (!committed)
			delete(workplace);
	}

	/** A name beside the target that no other run uses. */
	private static Path hidden(final Path parent, final Path target, final String what) {
		return parent
			.resolve("." + target.getFileName() + "." + what + "-" + ProcessHandle.current().pid()
				+ "-" + Long.toString(System.nanoTime(), Character.MAX_RADIX));
	}

	private static void move(final Path from, final Path to) throws IOException {
		try {
			Files.move(from, to, StandardCopyOption.ATOMIC_MOVE);
		} catch (final AtomicMoveNotSupportedException e) {
			Files.move(from, to);
		}
	}

	private static void delete(final Path folder) throws IOException {
		if (!Files.exists(folder))
			return;
		final List<Path> deepestFirst;
		try (Stream<Path> all = Files.walk(folder)) {
			deepestFirst = all.sorted(Comparator.reverseOrder()).toList();
		}
		for (final Path path : deepestFirst)
			Files.deleteIfExists(path);
	}

	private static Path existingParent(final Path target) {
		Path parent = target.getParent();
		while (parent != null && !Files.exists(parent))
			parent = parent.getParent();
		if (parent == null)
			throw new UserException(target + " is not a folder that can be written.");
		return parent;
	}

	private static boolean isEmpty(final Path folder) {
		try (Stream<Path> files = Files.list(folder)) {
			return files.findAny().isEmpty();
		} catch (final IOException e) {
			throw new UncheckedIOException(e);
		}
	}

	/**
	 * @param folder a folder, present or not
	 * @return whether it holds a finished result
	 */
	public static boolean isResult(final Path folder) {
		return ParametersJson.isOurs(folder.resolve(ParametersJson.FILE));
	}
}
