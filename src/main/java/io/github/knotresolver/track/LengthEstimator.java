package io.github.knotresolver.track;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.OptionalDouble;

import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.geometry.RobustStatistics;
import io.github.knotresolver.graph.GraphTuning;
import io.github.knotresolver.graph.RootedGraph;
import io.github.knotresolver.graph.SkeletonGraph;

/**
 * The filament's length from the frames in which it does not cross itself: the median
 * of those that agree with each other. A filament does not stretch; frames in which it
 * leaves the focus or folds onto itself are outliers.
 */
public final class LengthEstimator {

	private LengthEstimator() {
	}

	/**
	 * The length of the skeletons and of what thinning takes off their ends.
	 *
	 * @param frames the movie
	 * @param fixedEnd the fixed end in pixels; skeletons that end nowhere near it do not
	 *          count
	 * @return the length in pixels; empty if fewer than three frames are unbranched
	 */
	public static OptionalDouble estimate(final List<FrameGraph> frames, final Point fixedEnd) {
		final List<Double> lengths = new ArrayList<>();
		for (final FrameGraph f : frames)
			f.graph().filter(g -> g.isUnbranched() && endsNear(g, fixedEnd))
				.ifPresent(g -> lengths.add(g.length() + hidden(g, fixedEnd)));
		return lengths.size() < TrackTuning.UNBRANCHED
			? OptionalDouble.empty()
			: OptionalDouble
				.of(robustMedian(lengths.stream().mapToDouble(Double::doubleValue).toArray()));
	}

	/**
	 * What thinning takes off both ends of the filament: at the tip as much as at the fixed
	 * end, where it can be seen.
	 */
	static double hidden(final SkeletonGraph graph, final Point fixedEnd) {
		return 2 * RootedGraph.of(graph, fixedEnd).hidden(fixedEnd);
	}

	/**
	 * The median of the values that are not outliers.
	 *
	 * @param values at least one
	 * @return the median of those within three robust standard deviations, or 3 %, of the
	 *         median of all
	 */
	static double robustMedian(final double[] values) {
		final double median = RobustStatistics.median(values);
		final double spread = RobustStatistics.MAD_TO_SD * RobustStatistics
			.median(Arrays.stream(values).map(v -> Math.abs(v - median)).toArray());
		final double tolerance = Math.max(TrackTuning.SKELETON_OUTLIER * spread,
			TrackTuning.SKELETON_TOLERANCE * median);
		return RobustStatistics
			.median(Arrays.stream(values).filter(v -> Math.abs(v - median) <= tolerance).toArray());
	}

	private static boolean endsNear(final SkeletonGraph graph, final Point fixedEnd) {
		return graph.freeEnds().stream()
			.anyMatch(n -> n.position().distanceTo(fixedEnd) <= GraphTuning.NEAR_CLAMP);
	}
}
