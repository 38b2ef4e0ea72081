package io.github.knotresolver.track;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

import org.junit.jupiter.api.Test;

import io.github.knotresolver.Drawn;
import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.graph.SkeletonGraph;

class LengthEstimatorTest {

	private static List<FrameGraph> movie(final Polyline... curves) {
		final List<FrameGraph> frames = new ArrayList<>();
		for (final Polyline c : curves)
			frames.add(new FrameGraph(frames.size() + 1,
				Optional.of(SkeletonGraph.of(Drawn.skeleton(120, 80, c)))));
		return frames;
	}

	@Test
	void outliersAreLeftOut() {
		assertEquals(100.5,
			LengthEstimator.robustMedian(new double[]{100, 101, 50, 99, 102, 101, 100, 40, 160}),
			0.51);
		assertEquals(7, LengthEstimator.robustMedian(new double[]{7}));
		assertEquals(100, LengthEstimator.robustMedian(new double[]{100, 100, 100, 102, 40, 41}),
			0.01);
	}

	@Test
	void knottedAndForeignFramesDoNotCount() {
		final Polyline line = Drawn.line(10, 40, 90, 40);
		final Polyline knot = Drawn.line(10, 40, 50, 40, 60, 30, 50, 20, 40, 30, 40, 70);
		final Polyline elsewhere = Drawn.line(40, 10, 60, 10);
		// The skeleton begins 2 px after the fixed end, and so it ends.
		assertEquals(84, LengthEstimator
			.estimate(movie(line, knot, line, elsewhere, line), new Point(8, 40)).orElseThrow(),
			0.5);
		assertTrue(LengthEstimator.estimate(movie(line, knot, line), new Point(8, 40)).isEmpty());
	}
}
