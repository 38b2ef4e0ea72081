package io.github.knotresolver.io;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;

/**
 * What runs left that were killed: half a result is deleted, an earlier result
 * that was to be replaced comes back, and a complete result that was on its way
 * into its folder arrives. A run that is still alive holds its lock, and nothing
 * of it is touched.
 */
final class Leftovers {

	private Leftovers() {
	}

	/**
	 * @param names the hidden names beside the target, whose lock is held
	 * @param target where results go
	 * @throws IOException if files cannot be moved or deleted
	 */
	static void clear(final HiddenNames names, final Path target) throws IOException {
		for (final Path commit : names.present(HiddenNames.COMMIT))
			Replacement.finish(commit, target);
		for (final Path old : names.present(HiddenNames.OLD))
			if (!Files.exists(target))
				FileTrees.move(old, target);
			else if (ResultKind.of(target).isPresent())
				putBackForeign(old, target);
		clearPartial(names);
	}

	private static void clearPartial(final HiddenNames names) throws IOException {
		for (final Path partial : names.present(HiddenNames.PARTIAL))
			FileTrees.delete(partial);
	}

	/**
	 * Deletes the files of an earlier result that has been replaced. What else came
	 * into its folder meanwhile goes to where it was.
	 *
	 * @param old the earlier result's folder under its hidden name
	 * @param target the result that took its place
	 */
	static void putBackForeign(final Path old, final Path target) throws IOException {
		final Optional<ResultKind> kind = ResultKind.of(target);
		final List<String> names = FileTrees.names(old);
		for (final String name : names) {
			final Path file = old.resolve(name);
			if (kind.isPresent() && kind.get().owns(name) && !Files.isDirectory(file))
				Files.delete(file);
			else if (!Files.exists(target.resolve(name)))
				FileTrees.move(file, target.resolve(name));
		}
		if (FileTrees.names(old).isEmpty())
			Files.delete(old);
	}

	/**
	 * Clears what dead runs left in a folder of results.
	 *
	 * @param folder an existing folder
	 * @throws IOException if files cannot be moved or deleted
	 */
	static void clearAll(final Path folder) throws IOException {
		final Path real = folder.toRealPath();
		for (final HiddenNames names : HiddenNames.in(real)) {
			final Optional<FolderLock> lock = FolderLock.acquire(names.lock());
			if (lock.isEmpty())
				continue;
			try (FolderLock held = lock.get()) {
				if (names.isWhole())
					clear(names, real.resolve(names.name()));
				else
					clearPartial(names);
			}
		}
	}
}
