package io.github.knotresolver.candidate;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;
import java.util.TreeMap;

import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.graph.Node;
import io.github.knotresolver.graph.SkeletonGraph;
import io.github.knotresolver.graph.Step;

/** All legal trails of a small graph and their prices, the slow and obvious way. */
final class TrailOracle {

	private final SkeletonGraph graph;
	private final OptionalDouble known;
	private final TrailCandidates.Prices weights;
	private final List<Double> prices = new ArrayList<>();

	TrailOracle(final SkeletonGraph graph, final OptionalDouble known,
		final TrailCandidates.Prices weights) {
		this.graph = graph;
		this.known = known;
		this.weights = weights;
	}

	/** Prices of all trails from a node, each segment at most so often, sorted. */
	List<Double> prices(final Node root, final int maxUses) {
		for (final Step s : graph.stepsFrom(root))
			extend(new ArrayList<>(List.of(s)), maxUses);
		prices.sort(null);
		return prices;
	}

	private void extend(final List<Step> trail, final int maxUses) {
		final Step last = trail.get(trail.size() - 1);
		prices.add(price(trail, last.length()));
		if (known.isPresent()) {
			final double end = known.getAsDouble() - (length(trail) - last.length());
			if (end >= 1 && end <= last.length() - 1)
				prices.add(price(trail, end));
		}
		for (final Step next : graph.stepsFrom(last.to())) {
			final long used = trail.stream().filter(s -> s.segment() == next.segment()).count();
			final boolean reversal = next.segment() == last.segment()
				&& next.forward() != last.forward();
			if (used >= maxUses || reversal)
				continue;
			trail.add(next);
			extend(trail, maxUses);
			trail.remove(trail.size() - 1);
		}
	}

	private static double length(final List<Step> trail) {
		return trail.stream().mapToDouble(Step::length).sum();
	}

	double price(final List<Step> trail, final double end) {
		final TreeMap<Integer, Double> covered = new TreeMap<>();
		for (int i = 0; i < trail.size(); i++)
			covered.merge(trail.get(i).segment().id(),
				i < trail.size() - 1 ? trail.get(i).length() : end, Math::max);
		final double cover = covered.values().stream().mapToDouble(Double::doubleValue).sum();
		final double length = length(trail) - trail.get(trail.size() - 1).length() + end;
		double price = weights.turning() * turning(trail)
			+ weights.uncovered() * (graph.length() - cover);
		if (known.isPresent())
			price += weights.lengthMisfit() * Math.abs(length - known.getAsDouble());
		return price
			+ (known.isPresent() ? weights.overlap() : weights.overlapUnknown()) * (length - cover);
	}

	private static double turning(final List<Step> trail) {
		double turning = 0;
		int before = 0;
		boolean junction = false;
		for (int i = 1; i < trail.size(); i++) {
			junction |= trail.get(i).from().isJunction();
			if (trail.get(i).length() < CandidateTuning.NO_DIRECTION)
				continue;
			final Point a = trail.get(before).arrival(), b = trail.get(i).departure();
			if (junction)
				turning += 1 - a.x() * b.x() - a.y() * b.y();
			junction = false;
			before = i;
		}
		return turning;
	}
}
