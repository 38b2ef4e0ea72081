
package io.github.knotresolver.track;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.stream.DoubleStream;

import org.jgrapht.alg.connectivity.ConnectivityInspector;

import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.geometry.RobustStatistics;
import io.github.knotresolver.graph.Node;
import io.github.knotresolver.graph.Segment;
import io.github.knotresolver.graph.SkeletonGraph;
import io.github.knotresolver.progress.Progress;
import io.github.knotresolver.track.EndPaths.End;
import io.github.knotresolver.track.EndPaths.EndPath;

/**
 * Whether the graphs of a movie show beyond doubt that it holds one filament that is clamped:
 * one object with no more than two free ends in nearly all frames, and one end that hardly
 * moves in nearly all of those in which it lies open.
 */
public final class SingleFilament {

	private SingleFilament() {
	}

	/**
	 * O(frames² + segments).
	 *
	 * @param frames a movie
	 * @return whether it shows one clamped filament and nothing else
	 */
	public static boolean isClampedAlone(final List<FrameView> frames) {
		final List<List<Point>> open = new ArrayList<>();
		int alone = 0, seen = 0;
		for (final FrameView frame : frames) {
			final List<Set<Node>> objects = objects(frame.graph());
			if (objects.isEmpty())
				continue;
			seen++;
			final List<Point> ends = ends(frame.graph(), objects);
			if (objects.size() == 1 && ends.size() <= 2) {
				alone++;
				if (ends.size() == 2)
					open.add(ends);
			}
		}
		return seen > 0 && alone >= TrackTuning.NEARLY_ALL * seen
			&& open.size() >= Math.min(TrackTuning.FEWEST_OPEN, (seen + 1) / 2)
			&& staysInPlace(open);
	}

	/**
	 * O(segments).
	 *
	 * @param frames a movie
	 * @return whether nearly all of its frames show one object and nothing else
	 */
	public static boolean isOneObject(final List<FrameView> frames) {
		int one = 0, seen = 0;
		for (final FrameView frame : frames) {
			final int objects = objects(frame.graph()).size();
			seen += objects > 0 ? 1 : 0;
			one += objects == 1 ? 1 : 0;
		}
		return seen > 0 && one >= TrackTuning.NEARLY_ALL * seen;
	}

	/**
	 * O(objects segments) for each frame.
	 *
	 * @param frames a movie
	 * @return whether in most of its frames one object is longer than all others together
	 */
	public static boolean isMostlyOneObject(final List<FrameView> frames) {
		final double[] shares = frames.stream().map(FrameView::graph)
			.filter(g -> !g.segments().isEmpty()).mapToDouble(g -> {
				final double[] lengths = new ConnectivityInspector<>(g.asGraph()).connectedSets()
					.stream().mapToDouble(p -> length(g, p)).toArray();
				return DoubleStream.of(lengths).max().orElse(0) / DoubleStream.of(lengths).sum();
			}).toArray();
		return RobustStatistics.median(shares, 0) > TrackTuning.MAIN_OBJECT;
	}

	private static List<Set<Node>> objects(final SkeletonGraph graph) {
		final List<Set<Node>> parts = new ConnectivityInspector<>(graph.asGraph()).connectedSets();
		final double longest = parts.stream().mapToDouble(p -> length(graph, p)).max().orElse(0);
		return parts.stream().filter(p -> length(graph, p) >= Math.max(TrackTuning.SINGLE_SPECK,
			TrackTuning.SINGLE_SPECK_SHARE * longest)).toList();
	}

	private static double length(final SkeletonGraph graph, final Set<Node> part) {
		return graph.segments().stream().filter(s -> part.contains(s.source()))
			.mapToDouble(Segment::length).sum();
	}

	private static List<Point> ends(final SkeletonGraph graph, final List<Set<Node>> objects) {
		final Set<Node> kept = new HashSet<>();
		objects.forEach(kept::addAll);
		final List<Point> ends = new ArrayList<>();
		for (final Segment s : graph.segments())
			if (kept.contains(s.source()))
				for (final Node node : List.of(s.source(), s.target()))
					if (node.isFreeEnd()
						&& (s.length() >= TrackTuning.SINGLE_SPUR || graph.isUnbranched()))
						ends.add(node.position());
		return ends;
	}

	/** A stage that drifts, jitters or jumps carries the clamp along, but not far. */
	private static boolean staysInPlace(final List<List<Point>> open) {
		final List<End> ends = new ArrayList<>();
		for (int t = 0; t < open.size(); t++)
			for (final Point place : open.get(t))
				ends.add(new End(t, place, 0, 1));
		return EndPaths.best(ends, 2, Progress.NONE).stream()
			.anyMatch(p -> p.ends().size() >= TrackTuning.CLAMP_SEEN * open.size()
				&& p.votes() >= TrackTuning.CLAMP_VOTES * p.ends().size()
				&& range(p) <= TrackTuning.STAGE);
	}

	private static double range(final EndPath path) {
		double range = 0;
		for (final End a : path.ends())
			for (final End b : path.ends())
				range = Math.max(range, a.at().distanceTo(b.at()));
		return range;
	}
}
