package io.github.knotresolver.candidate;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.OptionalDouble;
import java.util.Set;

import org.jgrapht.alg.connectivity.ConnectivityInspector;

import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.graph.Node;
import io.github.knotresolver.graph.RootedGraph;
import io.github.knotresolver.graph.Segment;
import io.github.knotresolver.graph.SkeletonGraph;
import io.github.knotresolver.graph.Step;
import io.github.knotresolver.progress.Progress;

/**
 * Trails in which every segment may be used twice: two strands lying on each
 * other leave one skeleton line. A trail never reverses on the spot, and ends
 * at any node or inside a segment where the known length is used up (a tip
 * lying on the filament leaves no end point). No template is needed: a trail's
 * price is what it turns at junctions, leaves uncovered, misses of the known
 * length and walks twice.
 * <p>
 * The search is exact unless its beam is hit, which is reported. Of trails that
 * run within a few pixels of each other only the cheapest is given, so that the
 * candidates differ in how they thread the graph. Time and memory grow with
 * beam * number of segments.
 *
 * @param limit most candidates to give, at least 1
 * @param beam most trails to extend at a time, at least 1
 * @param maxUses how often a segment may be walked, at least 1
 * @param prices weights of the price
 */
public record TrailCandidates(int limit, int beam, int maxUses,
	Prices prices) implements CandidateGenerator {

	/** 40 candidates, every segment at most twice. */
	public static final TrailCandidates DEFAULT = new TrailCandidates(40, 1000, 2, Prices.DEFAULT);

	public TrailCandidates {
		if (limit < 1 || beam < 1 || maxUses < 1 || maxUses > Byte.MAX_VALUE)
			throw new IllegalArgumentException(
				"limit, beam and maxUses of the trails must be at least 1 (maxUses at most "
					+ Byte.MAX_VALUE + "), but are " + limit + ", " + beam + " and " + maxUses
					+ ".");
	}

	@Override
	public CandidateSet generate(final CandidateQuery query, final Progress progress) {
		final RootedGraph rooted = RootedGraph.of(query.graph(), query.fixedEnd());
		final SkeletonGraph graph = rooted.graph();
		final TrailPricing pricing = new TrailPricing(prices, visibleLength(rooted, query),
			reachable(rooted));
		final TrailSearch search = new TrailSearch(graph, pricing, maxUses, beam,
			limit * CandidateTuning.RAW_PER_CANDIDATE);
		final List<Candidate> raw = search.run(beginnings(rooted, query), progress);
		return new CandidateSet(different(raw), search.limited());
	}

	/** The known length less what the skeleton does not show at the fixed end. */
	private static OptionalDouble visibleLength(final RootedGraph rooted,
		final CandidateQuery query) {
		if (query.length().isEmpty())
			return query.length();
		final double length = query.length().getAsDouble();
		return OptionalDouble.of(Math.max(length / 2, length - rooted.hidden(query.fixedEnd())));
	}

	private static List<Trail> beginnings(final RootedGraph rooted, final CandidateQuery query) {
		final List<Trail> beginnings = new ArrayList<>();
		if (rooted.roots().isEmpty())
			return beginnings;
		final double nearest = rooted.roots().get(0).position().distanceTo(query.fixedEnd());
		for (final Node root : rooted.roots()) {
			final double start = Math.max(0,
				root.position().distanceTo(query.fixedEnd()) - nearest);
			for (final Step step : rooted.graph().stepsFrom(root))
				beginnings.add(Trail.along(step, rooted.graph().segments().size(), start));
		}
		return beginnings;
	}

	/** Length of the skeleton that can be reached at all. */
	private static double reachable(final RootedGraph rooted) {
		final ConnectivityInspector<Node, Segment> parts = new ConnectivityInspector<>(
			rooted.graph().asGraph());
		final Set<Node> reached = new HashSet<>();
		rooted.roots().forEach(r -> reached.addAll(parts.connectedSetOf(r)));
		return rooted.graph().segments().stream().filter(s -> reached.contains(s.source()))
			.mapToDouble(Segment::length).sum();
	}

	private List<Candidate> different(final List<Candidate> raw) {
		final List<Candidate> chosen = new ArrayList<>();
		final List<Polyline> ways = new ArrayList<>();
		for (final Candidate c : raw) {
			if (chosen.size() == limit)
				break;
			final Polyline way = Likeness.sample(c);
			if (ways.stream().noneMatch(w -> Likeness.alike(w, way))) {
				chosen.add(c);
				ways.add(way);
			}
		}
		return chosen;
	}

	/**
	 * Weights of the parts of a trail's price. The defaults were chosen on
	 * simulated spirals with known truth.
	 *
	 * @param turning pixels for a right-angled turn; a reversal costs twice as much
	 * @param uncovered per pixel of skeleton left out
	 * @param lengthMisfit per pixel too long or too short
	 * @param overlap per pixel walked a second time, if the length is known
	 * @param overlapUnknown the same if the length is not known and nothing else
	 *          holds a trail back from walking everything twice
	 */
	public record Prices(double turning, double uncovered, double lengthMisfit, double overlap,
		double overlapUnknown) {

		/** What has been found to work. */
		public static final Prices DEFAULT = new Prices(6, 1, 1, 0.1, 0.5);

		public Prices {
			if (!(turning >= 0 && uncovered >= 0 && lengthMisfit >= 0 && overlap >= 0
				&& overlapUnknown >= 0))
				throw new IllegalArgumentException(
					"Weights of prices must be at least 0, but are turning " + turning
						+ ", uncovered " + uncovered + ", lengthMisfit " + lengthMisfit
						+ ", overlap " + overlap + " and overlapUnknown " + overlapUnknown + ".");
		}
	}
}
