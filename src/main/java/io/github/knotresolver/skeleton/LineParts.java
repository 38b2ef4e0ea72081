package io.github.knotresolver.skeleton;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.function.IntPredicate;
import java.util.function.Predicate;

/** The connected parts of lines, each with its pixels in order of their finding. */
final class LineParts {

	private LineParts() {
	}

	/**
	 * Removes the parts that do not fit. O(n).
	 *
	 * @param line is changed
	 * @param fits told the places of a part's pixels in the image, row by row
	 */
	static void keep(final LinePixels line, final Predicate<int[]> fits) {
		for (final int[] part : of(line)) {
			final int[] inside = new int[part.length];
			for (int i = 0; i < part.length; i++)
				inside[i] = line.inside(part[i]);
			if (!fits.test(inside))
				for (final int at : part)
					line.remove(at);
		}
	}

	/** @return the places of each part's pixels */
	static List<int[]> of(final LinePixels line) {
		final List<int[]> parts = new ArrayList<>();
		final int[] pixels = line.pixels();
		final boolean[] seen = new boolean[pixels.length == 0 ? 0 : line.places()];
		final int[] queue = new int[pixels.length];
		for (final int start : pixels) {
			if (seen[start])
				continue;
			parts.add(part(line, start, seen, queue));
		}
		return parts;
	}

	private static int[] part(final LinePixels line, final int start, final boolean[] seen,
		final int[] queue) {
		int count = 0;
		queue[count++] = start;
		seen[start] = true;
		for (int i = 0; i < count; i++)
			for (int k = 0; k < 8; k++) {
				final int next = line.neighbour(queue[i], k);
				if (!line.has(next) || seen[next])
					continue;
				seen[next] = true;
				queue[count++] = next;
			}
		return Arrays.copyOf(queue, count);
	}

	/** @return how many of the places fit */
	static int count(final int[] places, final IntPredicate fits) {
		int count = 0;
		for (final int at : places)
			if (fits.test(at))
				count++;
		return count;
	}
}
