
package io.github.knotresolver.candidate;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.PriorityQueue;

import io.github.knotresolver.candidate.Candidate.Price;
import io.github.knotresolver.graph.SkeletonGraph;
import io.github.knotresolver.graph.Step;
import io.github.knotresolver.progress.Progress;

/**
 * Extends all trails by one step at a time, keeps the most promising, and
 * collects the cheapest that are finished. As long as the beam is not hit the
 * result is exact: what is dropped otherwise is provably too dear.
 */
final class TrailSearch {

	private record Finished(Trail trail, double end, Price price, int order) {
	}

	private record Open(Trail trail, double bound) {
	}

	private final SkeletonGraph graph;
	private final TrailPricing pricing;
	private final int maxUses;
	private final int beam;
	private final int wanted;
	private final PriorityQueue<Finished> cheapest = new PriorityQueue<>(
		Comparator.comparingDouble((Finished f) -> f.price().total())
			.thenComparingInt(Finished::order).reversed());
	private int finished;
	private boolean limited;

	TrailSearch(final SkeletonGraph graph, final TrailPricing pricing, final int maxUses,
		final int beam, final int wanted) {
		this.graph = graph;
		this.pricing = pricing;
		this.maxUses = maxUses;
		this.beam = beam;
		this.wanted = wanted;
	}

	/** The cheapest trails that begin with one of the given, cheapest first. */
	List<Candidate> run(final List<Trail> beginnings, final Progress progress) {
		List<Trail> front = beginnings;
		while (!front.isEmpty()) {
			progress.checkCancelled();
			front.forEach(this::finish);
			front = best(extended(front));
		}
		return cheapest.stream().sorted(cheapest.comparator().reversed())
			.map(f -> new Candidate(f.trail().steps(), f.end(), f.price())).toList();
	}

	/** Whether promising trails were dropped for want of room in the beam. */
	boolean limited() {
		return limited;
	}

	private void finish(final Trail trail) {
		offer(trail, trail.lastLength());
		pricing.cut(trail).ifPresent(end -> offer(trail, end));
	}

	private void offer(final Trail trail, final double end) {
		final Price price = pricing.price(trail, end);
		if (price.total() >= dearest())
			return;
		cheapest.add(new Finished(trail, end, price, finished++));
		if (cheapest.size() > wanted)
			cheapest.remove();
	}

	private double dearest() {
		return cheapest.size() < wanted
			? Double.POSITIVE_INFINITY
			: cheapest.element().price().total();
	}

	private List<Open> extended(final List<Trail> front) {
		final List<Open> next = new ArrayList<>();
		for (final Trail trail : front)
			for (final Step step : graph.stepsFrom(trail.at()))
				if (trail.allows(step, maxUses)) {
					final Trail longer = trail.then(step);
					next.add(new Open(longer, pricing.bound(longer)));
				}
		return next;
	}

	private List<Trail> best(final List<Open> open) {
		final List<Open> promising = new ArrayList<>(
			open.stream().filter(o -> o.bound() < dearest()).toList());
		promising.sort(Comparator.comparingDouble(Open::bound));
		if (promising.size() > beam)
			limited = true;
		return promising.stream().limit(beam).map(Open::trail).toList();
	}
}
