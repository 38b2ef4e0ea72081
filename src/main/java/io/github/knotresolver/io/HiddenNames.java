package io.github.knotresolver.io;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/**
 * Names of the hidden files and folders that a run has beside its result while
 * it works.
 *
 * @param base the folder that they lie in
 * @param name whose they are, short enough for any file system
 */
record HiddenNames(Path base, String name) {

	/** What is being written. */
	static final String PARTIAL = "partial";
	/** An earlier result while a new one takes its place. */
	static final String OLD = "old";
	/** A complete result whose files are on their way into a folder with other files. */
	static final String COMMIT = "commit";

	private static final int LONGEST = 200, HASH = 9;
	private static final Pattern OURS = Pattern
		.compile("\\.(.+)\\.(" + PARTIAL + "|" + OLD + "|" + COMMIT + ")-\\d+-[0-9a-z]+");

	/**
	 * @param base an existing folder
	 * @param target what is to be written, in or below it
	 * @return the names beside it
	 */
	static HiddenNames of(final Path base, final Path target) {
		final Path relative = target.startsWith(base) && !target.equals(base)
			? base.relativize(target)
			: target.getFileName();
		final String name = relative.toString().replace('/', '-').replace('\\', '-');
		return new HiddenNames(base, shortened(name));
	}

	private static String shortened(final String name) {
		if (name.getBytes(StandardCharsets.UTF_8).length < LONGEST)
			return name;
		String start = name;
		while (start.getBytes(StandardCharsets.UTF_8).length > LONGEST - HASH)
			start = start.substring(0, start.offsetByCodePoints(start.length(), -1));
		final String end = String.format(Locale.ROOT, "%08x", name.hashCode());
		return start
			+ "-".repeat(LONGEST - end.length() - start.getBytes(StandardCharsets.UTF_8).length)
			+ end;
	}

	/** @return whether this is the target's own name, not shortened */
	boolean isWhole() {
		return name.getBytes(StandardCharsets.UTF_8).length < LONGEST;
	}

	/** @return the file that a run locks while it writes */
	Path lock() {
		return base.resolve("." + name + ".lock");
	}

	/** @return a folder name that no other run uses */
	Path fresh(final String what) {
		return base.resolve("." + name + "." + what + "-" + ProcessHandle.current().pid() + "-"
			+ Long.toString(System.nanoTime() & Long.MAX_VALUE, Character.MAX_RADIX));
	}

	/** @return the folders of that kind that runs left here, or are using */
	List<Path> present(final String what) throws IOException {
		final String start = "." + name + "." + what + "-";
		try (Stream<Path> files = Files.list(base)) {
			return files.filter(f -> f.getFileName().toString().startsWith(start))
				.filter(f -> isOurs(f.getFileName().toString())).filter(HiddenNames::isRealFolder)
				.sorted().toList();
		}
	}

	/**
	 * @param folder a folder
	 * @return the names of all runs that left something in it, or are writing there
	 * @throws IOException if it cannot be read
	 */
	static List<HiddenNames> in(final Path folder) throws IOException {
		try (Stream<Path> files = Files.list(folder)) {
			return files.filter(HiddenNames::isRealFolder)
				.map(f -> OURS.matcher(f.getFileName().toString())).filter(Matcher::matches)
				.map(m -> m.group(1)).distinct().sorted().map(n -> new HiddenNames(folder, n))
				.toList();
		}
	}

	/** @return whether a run makes files or folders with that name while it works */
	static boolean isOurs(final String name) {
		return OURS.matcher(name).matches() || name.startsWith(".") && name.endsWith(".lock");
	}

	private static boolean isRealFolder(final Path path) {
		return Files.isDirectory(path) && !Files.isSymbolicLink(path);
	}
}
