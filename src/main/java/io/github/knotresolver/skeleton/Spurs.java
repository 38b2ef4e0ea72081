package io.github.knotresolver.skeleton;

import java.util.Comparator;
import java.util.PriorityQueue;
import java.util.function.Predicate;

import net.imglib2.RandomAccessibleInterval;
import net.imglib2.img.Img;
import net.imglib2.type.logic.BitType;

/** Takes short side branches from lines. */
public final class Spurs {

	private Spurs() {
	}

	/** A free end, and how far it is to where lines meet. */
	private record Spur(int end, int length) {
	}

	/**
	 * Removes side branches, the shortest first. What remains of a fork when one of its
	 * prongs has gone is measured anew, so that the end of a line that forks keeps one
	 * prong. A line without a junction stays, however short. Every end is walked from at
	 * most twice for each prong at its junction: O(pixels + ends log ends).
	 *
	 * @implNote op names="knotresolver.pruneSpurs"
	 * @param skeleton lines one pixel wide
	 * @param length branches of fewer pixels than this go
	 * @return a new skeleton of the same size
	 */
	public static Img<BitType> prune(final RandomAccessibleInterval<BitType> skeleton,
		final int length) {
		final LinePixels line = new LinePixels(skeleton);
		prune(line, length);
		return line.image();
	}

	/** @return how often an end was walked from */
	static int prune(final LinePixels line, final int length) {
		return prune(line, length, pixels -> true);
	}

	/**
	 * As {@link #prune(LinePixels, int)}, but only branches that are of no use.
	 *
	 * @param isUseless told the places of a branch's pixels
	 */
	static int prune(final LinePixels line, final int length, final Predicate<int[]> isUseless) {
		int walks = 0;
		final PriorityQueue<Spur> spurs = new PriorityQueue<>(
			Comparator.comparingInt(Spur::length).thenComparingInt(Spur::end));
		for (final int end : line.ends()) {
			add(spurs, line, end, length);
			walks++;
		}
		while (!spurs.isEmpty()) {
			walks++;
			final Spur spur = spurs.poll();
			final int[] pixels = line.walk(spur.end, length);
			if (pixels.length == spur.length) {
				if (isUseless.test(pixels))
					line.cut(pixels);
			} else
				add(spurs, line, spur.end, length);
		}
		line.thin();
		return walks;
	}

	private static void add(final PriorityQueue<Spur> spurs, final LinePixels line, final int end,
		final int length) {
		final int[] pixels = line.walk(end, length);
		if (pixels.length < length && line.meetsAfter(pixels))
			spurs.add(new Spur(end, pixels.length));
	}
}
