
package io.github.knotresolver.contour;

import java.util.ArrayList;
import java.util.List;

import io.github.knotresolver.candidate.Candidate;
import io.github.knotresolver.geometry.GaussianSmoothing;
import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.geometry.Polyline;

/** Makes contours of candidates. */
public final class ContourBuilder {

	/** Smoothing of corners at junctions, in pixels. */
	private static final double SIGMA = 2;

	private ContourBuilder() {
	}

	/**
	 * The candidate as a curve: through the junctions' centroids, lightly
	 * smoothed with both ends kept, and sampled at (nearly) one pixel.
	 *
	 * @param candidate a walk over a skeleton
	 * @return the contour in pixels, from the fixed end to the tip
	 */
	public static Polyline smooth(final Candidate candidate) {
		final Polyline even = candidate.path().resampled(1);
		return even.size() > 2 ? GaussianSmoothing.gaussian(even, SIGMA).resampled(1) : even;
	}

	/**
	 * The candidate as the pixels it passes, in order, as the published method
	 * leaves it. Within a segment that is the order of geodesic distance from
	 * where the walk enters it ({@link GeodesicOrder}).
	 *
	 * @param candidate a walk over a skeleton
	 * @return the contour in pixels, from the fixed end to the tip
	 */
	public static Polyline pixels(final Candidate candidate) {
		final List<Point> points = new ArrayList<>();
		for (int i = 0; i < candidate.steps().size(); i++) {
			final boolean last = i == candidate.steps().size() - 1;
			final Polyline chain = candidate.steps().get(i).chain();
			final Polyline used = last && candidate.endsInside()
				? chain.head(candidate.end())
				: chain;
			for (int k = i == 0 ? 0 : 1; k < used.size(); k++)
				points.add(used.point(k));
		}
		return Polyline.of(points);
	}
}
