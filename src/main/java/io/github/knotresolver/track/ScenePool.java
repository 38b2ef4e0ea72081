
package io.github.knotresolver.track;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;

import io.github.knotresolver.fit.Chain;
import io.github.knotresolver.geometry.Polyline;

/**
 * Filaments that many frames confirm, whichever pass they are from: what was followed over
 * much of the movie while all light around it was explained is no mistake of one frame. With
 * them drawn, the others are told apart more easily.
 */
final class ScenePool {

	private final SceneLine line;
	private final List<Known> filaments = new ArrayList<>();

	/** A filament in all frames, and where all light around it is explained. */
	private record Known(List<Chain> chains, boolean[] clear, int count) {
	}

	ScenePool(final SceneLine line) {
		this.line = line;
	}

	/**
	 * Adds the filaments of a pass that are clear in many frames.
	 *
	 * @return whether all its filaments are clear in nearly all frames
	 */
	boolean add(final PricedPass priced) {
		final ScenePass pass = priced.pass();
		final boolean[][] clear = priced.clear();
		int all = 0;
		for (int k = 0; k < pass.filaments(); k++) {
			int count = 0;
			for (final boolean c : clear[k])
				count += c ? 1 : 0;
			all += count >= SceneTuning.ALWAYS_CLEAR * clear[k].length ? 1 : 0;
			final List<Chain> chains = pass.filament(k);
			if (count >= SceneTuning.KNOWN_CLEAR * clear[k].length
				&& chains.get(0).length() >= line.shortestFilament())
				filaments.add(new Known(chains, clear[k], count));
		}
		filaments.sort(Comparator.comparingInt(Known::count).reversed());
		return all == clear.length;
	}

	boolean isEmpty() {
		return filaments.isEmpty();
	}

	/** The filaments that are known in a frame, each once. */
	List<Chain> known(final int t) {
		final List<Chain> known = new ArrayList<>();
		for (final Known f : filaments) {
			final Chain chain = f.chains.get(t);
			if (f.clear[t] && known.stream().noneMatch(c -> lieOnEachOther(c, chain)))
				known.add(chain);
		}
		return known;
	}

	/** The length of the filaments that are known in a frame, as a share of its light. */
	double coverage(final int t) {
		return known(t).stream().mapToDouble(Chain::length).sum()
			/ Math.max(1, line.lengthOfLight(t));
	}

	private static boolean lieOnEachOther(final Chain a, final Chain b) {
		final Polyline p = a.polyline(), q = b.polyline();
		return shareNear(p, q) > SceneTuning.OVERLAP || shareNear(q, p) > SceneTuning.OVERLAP;
	}

	private static double shareNear(final Polyline p, final Polyline q) {
		int near = 0;
		for (int i = 0; i < p.size(); i++)
			if (isNear(p, i, q))
				near++;
		return (double) near / p.size();
	}

	private static boolean isNear(final Polyline p, final int i, final Polyline q) {
		for (int k = 0; k + 1 < q.size(); k++)
			if (p.point(i).distanceToSegment(q.point(k), q.point(k + 1)) < SceneTuning.OVERLAP_NEAR)
				return true;
		return false;
	}
}
