package io.github.knotresolver.track;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.TreeSet;
import java.util.stream.IntStream;

import io.github.knotresolver.candidate.CandidateGenerator;
import io.github.knotresolver.candidate.CandidateQuery;
import io.github.knotresolver.candidate.CandidateSet;
import io.github.knotresolver.contour.ContourBuilder;
import io.github.knotresolver.contour.EqualArcDistance;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.model.FrameStatus;
import io.github.knotresolver.model.Observation;
import io.github.knotresolver.progress.Progress;
import io.github.knotresolver.progress.Workers;

/**
 * Our method on skeletons alone: the candidates of all frames are the vertices of a {@link Trellis},
 * and the cheapest path through it is the movie. The price of a vertex is the candidate's
 * own, that of an edge {@link ContourDistance}. The whole movie decides together,
 * forwards and backwards in time: a knotted first frame resolves itself, and a bad frame
 * cannot lead the following ones astray. Corrections are constraints.
 * <p>
 * A length that is neither told nor seen in unbranched frames is found by trying a few
 * and keeping the cheapest movie. A frame's confidence is 1 - exp(-gap / 10 px), where
 * gap is how much dearer the movie becomes if the frame takes a contour that differs
 * visibly.
 *
 * @param generator proposes contours
 * @param motion price of moving as far as is typical between frames, at least 0
 * @param workers threads; the result does not depend on their number
 */
public record TrellisResolver(CandidateGenerator generator, double motion,
	Workers workers) implements Resolver {

	/** Price of typical motion that has been found to work. */
	public static final double DEFAULT_MOTION = TrackTuning.SKELETON_MOTION;

	/** Quantiles of the single frames' guesses that are tried as the length. */
	private static final double[] QUANTILES = {0.1, 0.3, 0.5, 0.7, 0.9};

	/**
	 * The default weights, in the calling thread.
	 *
	 * @param generator proposes contours
	 */
	public TrellisResolver(final CandidateGenerator generator) {
		this(generator, TrackTuning.SKELETON_MOTION, Workers.HERE);
	}

	/** The contours among which one frame has the choice, what speaks against each, and a limit that was hit. */
	private record Column(List<Polyline> contours, List<Double> prices, String limitReason) {

		/** A frame in which nothing can be chosen. */
		static final Column NONE = new Column(List.of(), List.of(), "");

		static Column of(final CandidateSet set) {
			return new Column(set.candidates().stream().map(ContourBuilder::smooth).toList(),
				set.candidates().stream().map(c -> c.price().total()).toList(), set.limitReason());
		}

		double[] priceArray() {
			return prices.stream().mapToDouble(Double::doubleValue).toArray();
		}
	}

	private record Solution(List<Column> columns, TrellisPath path, OptionalDouble length) {
	}

	@Override
	public Track resolve(final ResolverQuery query, final Progress progress) {
		OptionalDouble length = query.length();
		if (length.isEmpty())
			length = LengthEstimator.estimate(query.frames(), query.fixedEnd());
		final Solution best = length.isPresent()
			? solve(query, length, progress)
			: tryLengths(query, progress);
		final List<Observation> frames = new ArrayList<>();
		for (int t = 0; t < query.frames().size(); t++)
			frames.add(tracked(query, best, t));
		return new Track(query.fixedEnd(), best.length.orElse(Double.NaN), Double.NaN, frames,
			Track.notes(frames));
	}

	private Solution tryLengths(final ResolverQuery query, final Progress progress) {
		Solution best = solve(query, OptionalDouble.empty(), progress);
		final TreeSet<Double> lengths = guesses(query, best);
		double cheapest = Double.POSITIVE_INFINITY;
		for (final double length : lengths) {
			final Solution s = solve(query, OptionalDouble.of(length), progress);
			if (s.path.total() < cheapest) {
				cheapest = s.path.total();
				best = s;
			}
		}
		return best;
	}

	private static TreeSet<Double> guesses(final ResolverQuery query, final Solution unknown) {
		final double[] lengths = IntStream.range(0, query.frames().size())
			.filter(t -> query.frames().get(t).graph().isPresent()
				&& !unknown.columns.get(t).contours().isEmpty())
			.mapToDouble(t -> unknown.columns.get(t).contours().get(0).length() + LengthEstimator
				.hidden(query.frames().get(t).graph().orElseThrow(), query.fixedEnd()))
			.sorted().toArray();
		final TreeSet<Double> guesses = new TreeSet<>();
		if (lengths.length > 0)
			for (final double q : QUANTILES)
				guesses.add(lengths[(int) Math.rint(q * (lengths.length - 1))]);
		guesses.remove(0.0);
		return guesses;
	}

	private Solution solve(final ResolverQuery query, final OptionalDouble length,
		final Progress progress) {
		final List<Column> columns = workers.map(query.frames().size(),
			t -> column(query, query.frames().get(t), length, progress));
		progress.report("Resolving", 0.5);
		final ContourDistance distance = new ContourDistance(
			columns.stream().map(Column::contours).toList(), motion, workers, progress);
		return new Solution(columns,
			Trellis.solve(columns.stream().map(Column::priceArray).toList(), distance, progress),
			length);
	}

	private Column column(final ResolverQuery query, final FrameGraph frame,
		final OptionalDouble length, final Progress progress) {
		final Polyline correction = query.corrections().get(frame.frame());
		if (correction != null)
			return new Column(List.of(correction), List.of(0.0), "");
		return frame.graph()
			.map(g -> Column
				.of(generator.generate(CandidateQuery.of(g, query.fixedEnd(), length), progress)))
			.orElse(Column.NONE);
	}

	private static Observation tracked(final ResolverQuery query, final Solution solution,
		final int t) {
		final FrameGraph frame = query.frames().get(t);
		final Column column = solution.columns.get(t);
		if (query.corrections().containsKey(frame.frame()))
			return frame.corrected(column.contours.get(0));
		if (frame.graph().isEmpty())
			return frame.lost();
		if (column.contours().isEmpty())
			return frame.withoutCandidates();
		final int chosen = solution.path.choice()[t];
		return new Observation(frame.frame(), FrameStatus.RESOLVED, column.limitReason,
			Optional.of(column.contours().get(chosen)), frame.junctions(), column.contours().size(),
			column.prices().get(chosen), confidence(solution, t, chosen));
	}

	private static double confidence(final Solution solution, final int t, final int chosen) {
		final List<Polyline> contours = solution.columns.get(t).contours();
		final double gap = solution.path.gap(t, v -> differ(contours.get(v), contours.get(chosen)));
		return 1 - Math.exp(-gap / TrackTuning.SKELETON_GAP);
	}

	private static boolean differ(final Polyline a, final Polyline b) {
		return Math.abs(a.length() - b.length()) > 2 * TrackTuning.VISIBLE
			|| EqualArcDistance.mean(a, b) > TrackTuning.VISIBLE;
	}
}
