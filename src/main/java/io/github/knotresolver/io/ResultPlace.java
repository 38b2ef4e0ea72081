package io.github.knotresolver.io;

import java.io.IOException;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.nio.file.attribute.BasicFileAttributes;
import java.util.Collection;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;

import io.github.knotresolver.model.UserException;

/**
 * A folder that a result is to be written to, and whether it may be: everything
 * that can be known before the work.
 *
 * @param out as the user named it
 * @param target the folder itself, links followed; present or not
 * @param base the existing folder in which the run's hidden files lie: that of the
 *          target or, where nothing can be moved to the target in one step, the
 *          target
 */
record ResultPlace(Path out, Path target, Path base) {

	/** Files that desktops leave in every folder. */
	private static final Set<String> OF_DESKTOPS = Set.of(".DS_Store", "Thumbs.db", "desktop.ini",
		".directory");
	/** As long as the longest name of a file in a result. */
	private static final String LONG_NAME = "tangent_angle_kymograph-100.tif";

	/**
	 * @param out the wanted folder
	 * @return the place
	 * @throws UserException if no folder can be there, in one sentence
	 */
	static ResultPlace of(final Path out) {
		final Path absolute = out.toAbsolutePath().normalize();
		requireReachable(out, absolute);
		try {
			final Path target = Files.exists(absolute) ? absolute.toRealPath() : absolute;
			if (target.getParent() == null)
				throw new UserException(
					"out " + out + " is the root of the file system; name a folder in it.");
			final Path parent = existing(target.getParent()).toRealPath();
			final boolean within = Files.isDirectory(target)
				&& (!Files.getFileStore(target).equals(Files.getFileStore(parent))
					|| !Files.isWritable(parent));
			return new ResultPlace(out, target, within ? target : parent);
		} catch (final IOException e) {
			throw new UserException(
				"out " + out + " cannot be used: " + e.getMessage() + "; choose another folder.",
				e);
		}
	}

	private static void requireReachable(final Path out, final Path absolute) {
		for (Path path = absolute; path != null; path = path.getParent())
			if (Files.isSymbolicLink(path) && !Files.exists(path))
				throw new UserException("out " + out + " leads through the link " + path
					+ " to a folder that is not there; make that folder, or choose another one.");
		final Path present = existing(absolute);
		if (!Files.isDirectory(present))
			throw new UserException(present.equals(absolute)
				? "out " + out + " is a file, but the result needs a folder; choose another name."
				: "out " + out + " cannot be written, because " + present
					+ " is a file; choose another folder.");
		if (isTooLong(absolute.resolve(LONG_NAME)))
			throw new UserException(
				"out " + out + " is longer than the file system allows; choose a shorter name.");
		if (!Files.isWritable(present))
			throw new UserException("out " + out + " cannot be written, because the folder "
				+ present + " is not writable; choose another one.");
	}

	/** The file system says so when it looks for the file. */
	static boolean isTooLong(final Path file) {
		try {
			Files.readAttributes(file, BasicFileAttributes.class, LinkOption.NOFOLLOW_LINKS);
			return false;
		} catch (final NoSuchFileException e) {
			return false;
		} catch (final FileSystemException e) {
			return String.valueOf(e.getReason()).toLowerCase(Locale.ROOT).contains("too long");
		} catch (final IOException e) {
			return false;
		}
	}

	/** @return the path, or what is there of the way to it */
	private static Path existing(final Path path) {
		Path present = path;
		while (!Files.exists(present, LinkOption.NOFOLLOW_LINKS)) {
			if (present.getParent() == null)
				throw new UserException("There is no folder " + present + ".");
			present = present.getParent();
		}
		return present;
	}

	/** @return the names of the run's hidden files */
	HiddenNames hidden() {
		return HiddenNames.of(base, target);
	}

	/**
	 * Checks that a result may be written.
	 *
	 * @param kind what is to be written
	 * @param overwrite whether an earlier result of that kind may be replaced
	 * @param inputs files and folders that are read
	 * @throws UserException if it may not, in one sentence
	 * @throws IOException if the folder cannot be read
	 */
	void check(final ResultKind kind, final boolean overwrite, final Collection<Path> inputs)
		throws IOException {
		requireNoInput(kind, inputs);
		if (!Files.exists(target) || isEmpty())
			return;
		final Optional<ResultKind> present = ResultKind.of(target);
		if (present.isEmpty())
			throw new UserException("out " + out
				+ " holds files that are not a result of this program; choose another one.");
		if (present.get() != kind)
			throw new UserException("out " + out + " holds " + present.get().label()
				+ ", which is never replaced by " + kind.label() + "; choose another folder.");
		if (!overwrite)
			throw new UserException("out " + out
				+ " already holds a result; choose another one, or add force to replace it.");
		for (final String name : own(kind))
			if (Files.isDirectory(target.resolve(name)))
				throw new UserException("out " + out + " has a folder named " + name
					+ " where the result needs a file; rename it, or choose another folder.");
	}

	private void requireNoInput(final ResultKind kind, final Collection<Path> inputs)
		throws IOException {
		if (!Files.exists(target))
			return;
		final List<String> own = own(kind);
		for (final Path input : inputs) {
			if (!Files.exists(input))
				continue;
			if (Files.isSameFile(input, target))
				throw new UserException("out " + out
					+ " is the folder that is read; choose another one for the result.");
			for (final String name : own)
				if (Files.isSameFile(input, target.resolve(name)))
					throw new UserException("out " + out + " holds " + name
						+ ", which is read and would be replaced; choose another folder.");
		}
	}

	/** @return the names in the folder that are those of files of such a result */
	List<String> own(final ResultKind kind) throws IOException {
		return Files.exists(target)
			? FileTrees.names(target).stream().filter(kind::owns).toList()
			: List.of();
	}

	/** @return whether nothing is in the folder but what nobody put there */
	boolean isEmpty() throws IOException {
		return FileTrees.names(target).stream()
			.allMatch(n -> OF_DESKTOPS.contains(n) || HiddenNames.isOurs(n));
	}

	/** @return whether the folder can be moved, as a whole, without moving files of others */
	boolean isAllOurs(final ResultKind kind) throws IOException {
		return !base.equals(target) && FileTrees.names(target).stream().allMatch(kind::owns);
	}
}
