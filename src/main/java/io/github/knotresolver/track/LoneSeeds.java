
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
		if (lone.size() < Math.max(SceneTuning.LONE_FEWEST, SceneTuning.LONE_MOST * seeds.size()))
			return false;
		final Point held = place(lone);
		final double[] off = distances(lone, held);
		return off[off.length / 2] <= SceneTuning.LONE_USUALLY
			&& off[(int) (SceneTuning.LONE_MOST * (off.length - 1))] <= SceneTuning.LONE_MOSTLY
			&& range(lone, held) > SceneTuning.LONE_FAR;
	}

	/** Of all ends the one to which the filament's nearer end is usually nearest. */
	private static Point place(final List<Chain> lone) {
		final List<Point> ends = new ArrayList<>();
		for (final Chain c : lone) {
			ends.add(c.start());
			ends.add(c.polyline().last());
		}
		return ends.stream()
			.min(Comparator.comparingDouble(p -> distances(lone, p)[lone.size() / 2]))
			.orElseThrow();
	}

	/** How far filaments' nearer ends are from a place, in pixels, rising. */
	private static double[] distances(final List<Chain> lone, final Point place) {
		return lone.stream().mapToDouble(c -> nearer(c, place)).sorted().toArray();
	}

	private static double nearer(final Chain chain, final Point place) {
		return Math.min(place.distanceTo(chain.start()), place.distanceTo(chain.polyline().last()));
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
