package io.github.knotresolver.paper;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;

import io.github.knotresolver.candidate.CandidateGenerator;
import io.github.knotresolver.candidate.CandidateQuery;
import io.github.knotresolver.candidate.CandidateSet;
import io.github.knotresolver.contour.ContourBuilder;
import io.github.knotresolver.contour.DynamicTimeWarping;
import io.github.knotresolver.contour.GeodesicOrder;
import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.graph.Node;
import io.github.knotresolver.graph.SkeletonGraph;
import io.github.knotresolver.model.FrameStatus;
import io.github.knotresolver.model.Observation;
import io.github.knotresolver.progress.Progress;
import io.github.knotresolver.track.FrameGraph;
import io.github.knotresolver.track.Resolver;
import io.github.knotresolver.track.ResolverQuery;
import io.github.knotresolver.track.Track;

/**
 * The published method: from frame to frame, the candidate nearest to the last
 * resolved contour by dynamic time warping wins. Unbranched skeletons are ordered by
 * geodesic distance from the fixed end. Knots before the first unbranched or
 * corrected frame need the user.
 *
 * @param generator proposes contours of branched frames; it is given the last
 *          resolved contour as its template
 */
public record PaperResolver(CandidateGenerator generator) implements Resolver {

	@Override
	public Track resolve(final ResolverQuery query, final Progress progress) {
		final List<Observation> frames = new ArrayList<>();
		Optional<Polyline> template = Optional.empty();
		for (final FrameGraph frame : query.frames()) {
			progress.checkCancelled();
			progress.report("Resolving", (double) frames.size() / query.frames().size());
			final Observation found = resolve(frame, query, template, progress);
			if (found.contour().isPresent())
				template = found.contour();
			frames.add(found);
		}
		return new Track(query.fixedEnd(), query.length().orElse(Double.NaN), Double.NaN, frames,
			Track.notes(frames));
	}

	private Observation resolve(final FrameGraph frame, final ResolverQuery query,
		final Optional<Polyline> template, final Progress progress) {
		final Polyline correction = query.corrections().get(frame.frame());
		if (correction != null)
			return frame.corrected(correction);
		if (frame.graph().isEmpty())
			return frame.lost();
		final SkeletonGraph graph = frame.graph().get();
		if (graph.isUnbranched())
			return new Observation(frame.frame(), FrameStatus.RESOLVED, "",
				Optional.of(ordered(graph, query.fixedEnd())), 0, 1, 0, 1);
		return template.isEmpty()
			? Observation.without(frame.frame(), FrameStatus.UNRESOLVED,
				"The filament crosses itself before it has been seen without a crossing; correct this frame to start from it.")
			: nearest(frame,
				new CandidateQuery(graph, query.fixedEnd(), OptionalDouble.empty(), template),
				progress);
	}

	/** The pixels from the free end that is nearest to the fixed end. */
	private static Polyline ordered(final SkeletonGraph graph, final Point fixedEnd) {
		final Polyline chain = graph.segments().get(0).chain();
		final Point first = graph.freeEnds().stream().map(Node::position)
			.min((a, b) -> Double.compare(a.distanceTo(fixedEnd), b.distanceTo(fixedEnd)))
			.orElseThrow();
		final List<Point> pixels = new ArrayList<>();
		for (int i = 0; i < chain.size(); i++)
			pixels.add(chain.point(i));
		final Polyline ordered = GeodesicOrder.order(pixels, first);
		// A chain that leads over a merged junction is no chain of pixels, but in order.
		if (ordered.size() == pixels.size())
			return ordered;
		return chain.first().equals(first) ? chain : chain.reversed();
	}

	private Observation nearest(final FrameGraph frame, final CandidateQuery query,
		final Progress progress) {
		final CandidateSet set = generator.generate(query, progress);
		final Polyline template = query.template().orElseThrow();
		Polyline best = null;
		double cost = Double.POSITIVE_INFINITY, second = Double.POSITIVE_INFINITY;
		for (final Polyline contour : set.candidates().stream().map(ContourBuilder::pixels)
			.toList()) {
			progress.checkCancelled();
			final double d = DynamicTimeWarping.distance(contour, template);
			second = Math.min(second, Math.max(d, cost));
			if (d < cost) {
				cost = d;
				best = contour;
			}
		}
		if (best == null)
			return frame.withoutCandidates();
		final double confidence = second > 0 && Double.isFinite(second)
			? 1 - cost / second
			: Double.isFinite(second) ? 0 : 1;
		return new Observation(frame.frame(), FrameStatus.RESOLVED, set.limitReason(),
			Optional.of(best), frame.junctions(), set.candidates().size(), cost, confidence);
	}
}
