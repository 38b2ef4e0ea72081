package io.github.knotresolver.track;

import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.IntStream;

import io.github.knotresolver.fit.Chain;
import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.geometry.RobustStatistics;

/**
 * What it costs a filament to change its course from one step to the next: its material keeps
 * its velocity, as far as that is usual in this movie. Where frames are close in time that tells
 * two strands apart that lie near each other for long: exchanged ones must have jumped once.
 * Remembers what it was asked for: one thread at a time.
 */
final class Inertia {

	private final double usual;
	private final AnchorPath anchor;
	private final Map<Chain, Polyline> nodes = new IdentityHashMap<>();

	/**
	 * Learns what is usual.
	 *
	 * @param chains one for each frame, as far as there is one
	 * @param anchor where the fixed end is; what it moves, all moves
	 */
	Inertia(final List<Optional<Chain>> chains, final AnchorPath anchor) {
		this.anchor = anchor;
		final double[] changes = IntStream.range(1, Math.max(1, chains.size() - 1))
			.filter(t -> chains.subList(t - 1, t + 2).stream().allMatch(Optional::isPresent))
			.mapToDouble(t -> change(t, chains.get(t - 1).get(), chains.get(t).get(),
				chains.get(t + 1).get()))
			.toArray();
		usual = Math.max(TrackTuning.LEAST_CHANGE, RobustStatistics.upperMedian(changes, 0));
	}

	/** @return the usual change of velocity, mean over the filament, in pixels per frame */
	double usual() {
		return usual;
	}

	/**
	 * @param t index of the middle one of three frames
	 * @return the price, at least 0
	 */
	double price(final int t, final Chain before, final Chain here, final Chain after) {
		return MotionPrice.price(change(t, before, here, after) / usual);
	}

	/** Mean change of velocity of the nodes; of filaments that grow, of the part that all have. */
	private double change(final int t, final Chain before, final Chain here, final Chain after) {
		final double shortest = Math.min(here.length(), Math.min(before.length(), after.length()));
		final Polyline a = nodes(before, shortest), b = nodes(here, shortest),
			c = nodes(after, shortest);
		final Point p = anchor.places().get(t - 1), q = anchor.places().get(t),
			r = anchor.places().get(t + 1);
		final double moveX = p.x() + r.x() - 2 * q.x(), moveY = p.y() + r.y() - 2 * q.y();
		double sum = 0;
		for (int i = 0; i < b.size(); i++) {
			final double dx = a.x(i) + c.x(i) - 2 * b.x(i) - moveX,
				dy = a.y(i) + c.y(i) - 2 * b.y(i) - moveY;
			sum += Math.sqrt(dx * dx + dy * dy);
		}
		return sum / b.size();
	}

	private Polyline nodes(final Chain chain, final double length) {
		final Chain resized = chain.resized(length);
		return resized == chain
			? nodes.computeIfAbsent(chain, Chain::polyline)
			: resized.polyline();
	}
}
