
package io.github.knotresolver.track;

import java.util.List;
import java.util.OptionalDouble;
import java.util.stream.IntStream;

import io.github.knotresolver.fit.NormalizedFrame;
import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.graph.Node;

/**
 * How bright it is where strands cross: where light adds up, as bright as two strands; where it
 * saturates, nothing is brighter than one.
 */
final class CrossingLight {

	private CrossingLight() {
	}

	/**
	 * The light that a tenth of all junctions exceed: most are places where strands only come
	 * near each other, or a skeleton has a spur. O(junctions).
	 *
	 * @param frames frames with the light in strands
	 * @return in strands; empty if there are too few junctions to tell
	 */
	static OptionalDouble of(final List<FrameView> frames) {
		final double[] seen = frames.stream()
			.flatMapToDouble(f -> f.graph().nodes().stream().filter(Node::isJunction)
				.mapToDouble(n -> at(f.light(), n.position())))
			.filter(Double::isFinite).sorted().toArray();
		return seen.length < SceneTuning.CROSSINGS_FEWEST
			? OptionalDouble.empty()
			: OptionalDouble.of(seen[(int) (SceneTuning.CROSSINGS_QUANTILE * (seen.length - 1))]
				/ SceneTuning.MEAN_OF_RIDGE);
	}

	/**
	 * The light of the brightest place on any line: where light adds up, strands that lie on each
	 * other are as bright as two somewhere, whatever their skeleton looks like. O(pixels of
	 * skeletons).
	 *
	 * @param frames frames with the light in strands
	 * @return in strands; 0 if there is no line
	 */
	static double brightest(final List<FrameView> frames) {
		return frames.stream()
			.flatMapToDouble(f -> f.graph().segments().stream()
				.flatMapToDouble(s -> IntStream.range(0, s.curve().size())
					.mapToDouble(i -> f.light().meanAround(s.curve().x(i), s.curve().y(i)))))
			.filter(Double::isFinite).max().orElse(0) / SceneTuning.MEAN_OF_RIDGE;
	}

	/** The brightest 3 x 3 pixels around a place. */
	private static double at(final NormalizedFrame light, final Point place) {
		double most = Double.NEGATIVE_INFINITY;
		for (int dy = -SceneTuning.CROSSING_NEAR; dy <= SceneTuning.CROSSING_NEAR; dy++)
			for (int dx = -SceneTuning.CROSSING_NEAR; dx <= SceneTuning.CROSSING_NEAR; dx++) {
				final double here = light.meanAround(place.x() + dx, place.y() + dy);
				if (here > most)
					most = here;
			}
		return most;
	}
}
