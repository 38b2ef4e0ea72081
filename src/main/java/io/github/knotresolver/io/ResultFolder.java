package io.github.knotresolver.io;

import java.io.IOException;
import java.nio.file.DirectoryNotEmptyException;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Collection;
import java.util.List;
import java.util.Optional;

import io.github.knotresolver.model.UserException;

/**
 * A folder of results that is complete or absent: files are written into a
 * hidden folder beside it, which takes the wanted name at the end. The place is
 * reserved before the work, so that what makes it impossible is said at once,
 * and no other run writes there meanwhile.
 *
 * <pre>
 * try (ResultFolder folder = ResultFolder.reserve(out, kind, false, List.of(movie))) {
 * 	work();
 * 	write(folder.path());
 * 	folder.commit();
 * }
 * </pre>
 *
 * Closing without {@link #commit()} removes everything that was written. Of an
 * earlier result only the files that this program gives such a folder are
 * replaced, by their names ({@link ResultKind#owns}); all others stay, and so
 * does every folder in it. What a killed run left is cleared by the next one.
 */
public final class ResultFolder implements AutoCloseable {

	private final ResultPlace place;
	private final ResultKind kind;
	private final boolean overwrite;
	private final FolderLock lock;
	private final Path workplace;
	private boolean committed;

	private ResultFolder(final ResultPlace place, final ResultKind kind, final boolean overwrite,
		final FolderLock lock) throws IOException {
		this.place = place;
		this.kind = kind;
		this.overwrite = overwrite;
		this.lock = lock;
		this.workplace = Files.createDirectory(place.hidden().fresh(HiddenNames.PARTIAL));
	}

	/**
	 * Reserves a folder for writing.
	 *
	 * @param out the wanted folder; it may be absent or empty, and missing parents
	 *          are made at the end
	 * @param kind what is to be written
	 * @param overwrite whether an earlier result of that kind may be replaced; a
	 *          folder that holds anything else never is
	 * @param inputs files and folders that are read meanwhile; they are never
	 *          replaced
	 * @return the folder, to be committed and closed
	 * @throws UserException if it may not be written, in one sentence
	 * @throws IOException if the hidden folder cannot be made
	 */
	public static ResultFolder reserve(final Path out, final ResultKind kind,
		final boolean overwrite, final Collection<Path> inputs) throws IOException {
		final ResultPlace place = ResultPlace.of(out);
		final HiddenNames hidden = place.hidden();
		final FolderLock lock = FolderLock.acquire(hidden.lock())
			.orElseThrow(() -> new UserException("out " + out
				+ " is being written by another run; wait for it, or choose another folder."));
		try {
			Leftovers.clear(hidden, place.target());
			place.check(kind, overwrite, inputs);
			return new ResultFolder(place, kind, overwrite, lock);
		} catch (final IOException | RuntimeException e) {
			lock.close();
			throw e;
		}
	}

	/** @return where the files are written until {@link #commit()} */
	public Path path() {
		return workplace;
	}

	/**
	 * Gives the folder its name; an earlier result is replaced.
	 *
	 * @throws IOException if that fails; the earlier result is kept then
	 */
	public void commit() throws IOException {
		final List<String> strangers = FileTrees.names(workplace).stream()
			.filter(n -> !kind.owns(n)).toList();
		if (!strangers.isEmpty())
			throw new IllegalStateException(
				"Files of " + kind + " without an agreed name: " + strangers);
		final Path target = place.target();
		Files.createDirectories(target.getParent());
		if (!Files.exists(target) || FileTrees.names(target).isEmpty() && !isWithin())
			moveWhole(target);
		else
			replace(target);
		committed = true;
	}

	private boolean isWithin() {
		return place.base().equals(place.target());
	}

	/** The file system refuses to move a folder over one that has got files meanwhile. */
	private void moveWhole(final Path target) throws IOException {
		try {
			FileTrees.move(workplace, target);
		} catch (final DirectoryNotEmptyException e) {
			throw taken(e);
		} catch (final FileSystemException e) {
			if (!Files.isDirectory(target))
				throw e;
			// Some systems do not even move it over an empty one.
			try {
				Files.delete(target);
			} catch (final DirectoryNotEmptyException full) {
				throw taken(full);
			}
			FileTrees.move(workplace, target);
		}
	}

	private IOException taken(final Exception cause) {
		return new IOException(
			"another run has written to " + place.out() + " meanwhile; choose another folder",
			cause);
	}

	private void replace(final Path target) throws IOException {
		final Optional<ResultKind> present = ResultKind.of(target);
		final boolean replaceable = present.isEmpty()
			? place.isEmpty()
			: overwrite && present.get() == kind;
		if (!replaceable)
			throw taken(null);
		if (place.isAllOurs(kind))
			swap(target);
		else
			Replacement.run(workplace, place.hidden(), target, place.own(kind));
	}

	private void swap(final Path target) throws IOException {
		final Path old = place.hidden().fresh(HiddenNames.OLD);
		FileTrees.move(target, old);
		try {
			FileTrees.move(workplace, target);
		} catch (final IOException e) {
			FileTrees.move(old, target);
			throw e;
		}
		Leftovers.putBackForeign(old, target);
	}

	/** Removes what was written, unless it was committed. */
	@Override
	public void close() throws IOException {
		try {
			if (!committed)
				FileTrees.delete(workplace);
		} finally {
			lock.close();
		}
	}

	/**
	 * @param folder a folder, present or not
	 * @return whether it holds a finished result
	 */
	public static boolean isResult(final Path folder) {
		return ResultKind.of(folder).isPresent();
	}
}
