package io.github.knotresolver.io;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/**
 * Takes a complete result into a folder that has other files as well, which
 * stay: files of the earlier result go, by name, {@code parameters.json} first,
 * then those of the new one come, {@code parameters.json} last. Between the two
 * the folder holds no result.
 * <p>
 * A run that dies meanwhile leaves its folder with what was still to be done;
 * {@link #finish(Path, Path)} does the rest.
 */
final class Replacement {

	/** The names to be deleted, one a line; gone when that is done. */
	private static final String TO_DELETE = ".to-delete";

	private Replacement() {
	}

	/**
	 * @param complete a folder with a complete result
	 * @param names the hidden names beside the target
	 * @param target an existing folder
	 * @param earlier the names of the files of the earlier result in it
	 * @throws IOException if the files cannot be moved
	 */
	static void run(final Path complete, final HiddenNames names, final Path target,
		final List<String> earlier) throws IOException {
		Files.write(complete.resolve(TO_DELETE), earlier, StandardCharsets.UTF_8);
		final Path commit = names.fresh(HiddenNames.COMMIT);
		FileTrees.move(complete, commit);
		finish(commit, target);
	}

	/**
	 * Does what is still to be done; may be called again after it failed.
	 *
	 * @param commit what {@link #run} left
	 * @param target the folder that gets the result; made if absent
	 * @throws IOException if the files cannot be moved
	 */
	static void finish(final Path commit, final Path target) throws IOException {
		final Path list = commit.resolve(TO_DELETE);
		if (Files.exists(list)) {
			for (final String name : parametersFirst(
				Files.readAllLines(list, StandardCharsets.UTF_8)))
				Files.deleteIfExists(target.resolve(name));
			Files.delete(list);
		}
		Files.createDirectories(target);
		final List<String> names = new ArrayList<>(parametersFirst(FileTrees.names(commit)));
		for (int i = names.size() - 1; i >= 0; i--)
			FileTrees.replace(commit.resolve(names.get(i)), target.resolve(names.get(i)));
		Files.delete(commit);
	}

	private static List<String> parametersFirst(final List<String> names) {
		final List<String> sorted = new ArrayList<>(names);
		if (sorted.remove(ParametersJson.FILE))
			sorted.add(0, ParametersJson.FILE);
		return sorted;
	}
}
