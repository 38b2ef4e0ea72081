package io.github.knotresolver.track;

import java.util.Set;

import org.jgrapht.alg.connectivity.ConnectivityInspector;

import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.graph.Node;
import io.github.knotresolver.graph.Segment;
import io.github.knotresolver.graph.SkeletonGraph;

/** How much of the objects under a contour it does not run along. */
final class Uncovered {

	private Uncovered() {
	}

	/**
	 * O(length of skeleton times length of contour).
	 *
	 * @param graph all skeletons of the frame
	 * @param contour in pixels
	 * @return length of skeleton that is not covered but connected to some that is, as a
	 *         share of the contour's length
	 */
	static double share(final SkeletonGraph graph, final Polyline contour) {
		double missed = 0;
		for (final Set<Node> part : new ConnectivityInspector<>(graph.asGraph()).connectedSets()) {
			double far = 0, all = 0;
			for (final Segment segment : graph.segments())
				if (part.contains(segment.source())) {
					far += far(segment, contour);
					all += segment.length();
				}
			if (far < all)
				missed += far;
		}
		return missed / contour.length();
	}

	private static double far(final Segment segment, final Polyline contour) {
		int far = 0;
		for (int i = 0; i < segment.curve().size(); i++)
			if (distance(segment.curve().point(i), contour) > TrackTuning.COVERED)
				far++;
		return segment.length() * far / segment.curve().size();
	}

	private static double distance(final Point place, final Polyline contour) {
		double nearest = Double.POSITIVE_INFINITY;
		for (int i = 0; i < contour.size(); i++)
			nearest = Math.min(nearest, contour.point(i).distanceTo(place));
		return nearest;
	}
}
