
package io.github.knotresolver.track;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;

import io.github.knotresolver.fit.Chain;
import io.github.knotresolver.geometry.Point;

/**
 * Whether a few frames of a movie, looked at without knowing anything, show one filament that is
 * held at one end, and nothing besides that is long enough to be another one: then it need not be
 * followed to know.
 */
final class LoneSeeds {

	/** It must be so in this share of the frames, and of so many at least: debris spoils some. */
	private static final double MOST = 0.75;
	private static final int FEWEST = 8;

	/** The held end is usually this near (pixels) to its place, and in most frames so near. */
	private static final double USUALLY = 8, MOSTLY = 16;

	/** The other end is in places that are so far apart (pixels). */
	private static final double FAR = 32;

	private LoneSeeds() {
	}

	/**
	 * O(frames²).
	 *
	 * @param seeds what some frames show
	 * @param speck chains shorter than this (pixels) are no filaments
	 * @return whether they show one filament that is held, beyond doubt
	 */
	static boolean areOfOneClamped(final List<SceneSeed> seeds, final double speck) {
		final List<Chain> lone = new ArrayList<>();
		for (final SceneSeed seed : seeds) {
			final List<Chain> filaments = seed.chains().stream().filter(c -> c.length() >= speck)
				.toList();
			if (filaments.size() == 1)
				lone.add(filaments.get(0));
		}
		if (lone.size() < Math.max(FEWEST, MOST * seeds.size()))
			return false;
		final Point held = place(lone);
		final double[] off = distances(lone, held);
		return off[off.length / 2] <= USUALLY && off[(int) (MOST * (off.length - 1))] <= MOSTLY
			&& range(lone, held) > FAR;
	}

	/** Of all ends the one to which the filament's nearer end is usually nearest. */
	private static Point place(final List<Chain> lone) {
		final List<Point> ends = new ArrayList<>();
		for (final Chain c : lone) {
			ends.add(c.start());
			ends.add(c.polyline().last());
		}
		return ends.stream()
			.min(Comparator.comparingDouble(p -> distances(lone, p)[lone.size() / 2])).orElseThrow();
	}

	/** How far filaments' nearer ends are from a place, in pixels, rising. */
	private static double[] distances(final List<Chain> lone, final Point place) {
		return lone.stream().mapToDouble(c -> nearer(c, place)).sorted().toArray();
	}

	private static double nearer(final Chain chain, final Point place) {
		return Math.min(place.distanceTo(chain.start()),
			place.distanceTo(chain.polyline().last()));
	}

	/** The largest distance between places of the end that is farther from where one is held. */
	private static double range(final List<Chain> lone, final Point held) {
		final List<Point> loose = lone.stream()
			.map(c -> held.distanceTo(c.start()) > held.distanceTo(c.polyline().last())
				? c.start()
				: c.polyline().last())
			.toList();
		return loose.stream().flatMapToDouble(p -> loose.stream().mapToDouble(p::distanceTo)).max()
			.orElse(0);
	}
}
