package io.github.knotresolver.io;

import java.nio.charset.StandardCharsets;
import java.text.Normalizer;
import java.util.HashSet;
import java.util.Locale;
import java.util.Set;
import java.util.function.Predicate;
import java.util.regex.Pattern;

/**
 * Names of result folders, made from names of movies: one plain folder name that
 * Linux, macOS and Windows all take, and no two that one of them takes for the
 * same.
 */
public final class FolderNames {

	private static final String NAMELESS = "movie";
	private static final int LONGEST_BYTES = 180;
	private static final Pattern ENDING = Pattern.compile("\\.[^.]*$");
	private static final Pattern FORBIDDEN = Pattern.compile("[\\p{Cntrl}<>:\"/\\\\|?*]");
	private static final Pattern OUTER_DOTS = Pattern.compile("^[. ]+|[. ]+$");
	private static final Pattern DEVICE = Pattern
		.compile("(?i)(con|prn|aux|nul|com\\d|lpt\\d)(\\..*)?");

	private final Set<String> taken = new HashSet<>();

	/** @param reserved names that no folder may have */
	public FolderNames(final String... reserved) {
		for (final String name : reserved)
			take(name);
	}

	/**
	 * @param movie the name of a movie's file
	 * @param isFree whether a folder name may be used
	 * @return the movie's name without its ending; numbered if it is taken
	 */
	public String next(final String movie, final Predicate<String> isFree) {
		final String stem = stem(movie);
		String name = stem;
		for (int i = 2; taken.contains(key(name)) || !isFree.test(name); i++)
			name = stem + "-" + i;
		take(name);
		return name;
	}

	/** @param name a name that no other folder shall get */
	public void take(final String name) {
		taken.add(key(name));
	}

	/**
	 * @param movie the name of a movie's file
	 * @return a plain folder name
	 */
	static String stem(final String movie) {
		final String plain = FORBIDDEN.matcher(movie).replaceAll("_");
		String stem = OUTER_DOTS.matcher(ENDING.matcher(plain).replaceFirst("")).replaceAll("");
		while (stem.getBytes(StandardCharsets.UTF_8).length > LONGEST_BYTES)
			stem = stem.substring(0, stem.offsetByCodePoints(stem.length(), -1));
		stem = OUTER_DOTS.matcher(stem).replaceAll("");
		if (stem.isEmpty())
			return NAMELESS;
		return DEVICE.matcher(stem).matches() ? "_" + stem : stem;
	}

	/** Windows and macOS take a letter and its capital, and accents of two kinds, for the same. */
	private static String key(final String name) {
		return Normalizer.normalize(name, Normalizer.Form.NFC).toUpperCase(Locale.ROOT)
			.toLowerCase(Locale.ROOT);
	}
}
