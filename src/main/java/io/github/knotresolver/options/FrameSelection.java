
package io.github.knotresolver.options;

import java.util.SortedSet;
import java.util.StringJoiner;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

import io.github.knotresolver.model.UserException;

/**
 * Frames as people write them: {@code 1-40,45}. Frames count from 1. The
 * original tool's lists, {@code [1 5 7]} and {@code 1;5;7}, are read too.
 */
public final class FrameSelection {

	/** No movie has more. */
	private static final int MOST_FRAMES = 1_000_000;

	private static final Pattern PART = Pattern.compile("(\\d{1,7})(?:-(\\d{1,7}))?");

	private FrameSelection() {
	}

	/**
	 * @param key the option's name, for the sentence that refuses
	 * @param text numbers and ranges
	 * @return the frames; empty if the text is blank or {@code []}
	 */
	public static SortedSet<Integer> parse(final String key, final String text) {
		final String list = text.strip().replaceFirst("^\\[(.*)]$", "$1").strip()
			.replaceAll("\\s*-\\s*", "-");
		final SortedSet<Integer> frames = new TreeSet<>();
		if (!list.isEmpty())
			for (final String part : list.split("[\\s,;]+", -1))
				addRange(key, text, part, frames);
		return frames;
	}

	private static void addRange(final String key, final String text, final String part,
		final SortedSet<Integer> frames) {
		final Matcher matcher = PART.matcher(part);
		final boolean known = matcher.matches();
		final int from = known ? Integer.parseInt(matcher.group(1)) : 0;
		final int to = known && matcher.group(2) != null
			? Integer.parseInt(matcher.group(2))
			: from;
		if (from < 1 || to < from)
			throw new UserException(
				key + " must be frames counted from 1, such as 1-40,45, but is '" + text.strip()
					+ "'.");
		if (to > MOST_FRAMES)
			throw new UserException(key + " must be frames of a movie, from 1 to " + MOST_FRAMES
				+ ", but is '" + text.strip() + "'.");
		for (int frame = from; frame <= to; frame++)
			frames.add(frame);
	}

	/**
	 * @param frames frames, counted from 1
	 * @return the shortest text that {@link #parse} reads back
	 */
	public static String format(final SortedSet<Integer> frames) {
		final StringJoiner text = new StringJoiner(",");
		int from = -1, to = -1;
		for (final int frame : frames) {
			if (from > 0 && frame != to + 1) {
				text.add(range(from, to));
				from = frame;
			}
			if (from < 0)
				from = frame;
			to = frame;
		}
		if (from > 0)
			text.add(range(from, to));
		return text.toString();
	}

	private static String range(final int from, final int to) {
		return from == to ? Integer.toString(from) : from + "-" + to;
	}
}
