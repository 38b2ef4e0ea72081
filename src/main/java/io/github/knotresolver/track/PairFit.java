
package io.github.knotresolver.track;

import java.util.List;
import java.util.Optional;

import io.github.knotresolver.fit.Chain;
import io.github.knotresolver.fit.FitSettings;
import io.github.knotresolver.fit.Scene;

/** Two filaments of a frame that are fitted in turn, all others drawn. */
final class PairFit {

	private final Scene scene;
	private final int first;
	private final int second;
	private final FitSettings settings;
	private final int sweeps;

	/** Two filaments in a frame, and what they cost; NaN if they are not priced. */
	record Two(Chain a, Chain b, double price) {
	}

	/**
	 * @param scene a frame in which these two are not drawn
	 * @param first number of one of them
	 * @param second number of the other
	 * @param settings weights
	 * @param sweeps so often they take turns at most
	 */
	PairFit(final Scene scene, final int first, final int second, final FitSettings settings,
		final int sweeps) {
		this.scene = scene;
		this.first = first;
		this.second = second;
		this.settings = settings;
		this.sweeps = sweeps;
	}

	/** What two chains cost: the light that each explains beside the other, and bending. */
	double price(final Chain a, final Chain b) {
		final double one = scene.window(List.of(b)).price(b, settings).energy();
		scene.put(second, b);
		final double other = scene.window(List.of(a)).price(a, settings).energy();
		scene.take(second);
		return one + other;
	}

	/** Two chains near others, until neither moves. */
	Two fitted(final Chain startA, final Chain startB) {
		Two now = new Two(startA, startB, Double.NaN);
		double moved = Double.POSITIVE_INFINITY;
		for (int sweep = 0; sweep < sweeps && moved > SceneTuning.HALVES_STILL; sweep++) {
			final Two before = now;
			now = swept(before);
			moved = Math.max(now.a.farthest(before.a), now.b.farthest(before.b));
		}
		return new Two(now.a, now.b, price(now.a, now.b));
	}

	/** Each of two chains fitted once beside the other; not priced. */
	Two swept(final Two start) {
		scene.put(second, start.b);
		final Chain a = fit(start.a);
		scene.take(second);
		scene.put(first, a);
		final Chain b = fit(start.b);
		scene.take(first);
		return new Two(a, b, Double.NaN);
	}

	private Chain fit(final Chain start) {
		return scene.window(List.of(start)).fit(start, Optional.of(start), settings).chain();
	}
}
