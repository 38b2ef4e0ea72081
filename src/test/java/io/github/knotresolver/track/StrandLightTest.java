package io.github.knotresolver.track;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;

import org.junit.jupiter.api.Test;

import io.github.knotresolver.candidate.CandidateQuery;
import io.github.knotresolver.candidate.CandidateSet;
import io.github.knotresolver.candidate.TrailCandidates;
import io.github.knotresolver.fit.Chain;
import io.github.knotresolver.fit.DrawnMovie;
import io.github.knotresolver.fit.LineModel;
import io.github.knotresolver.fit.NormalizedFrame;
import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.graph.SkeletonGraph;
import io.github.knotresolver.image.FrameCleaner;
import io.github.knotresolver.image.Pixels;
import io.github.knotresolver.mask.FilamentSegmenter;
import io.github.knotresolver.model.Cleaning;
import io.github.knotresolver.model.Segmentation;
import io.github.knotresolver.progress.Progress;
import io.github.knotresolver.skeleton.Skeletonize;

class StrandLightTest {

	private static final double LENGTH = 75, RADIUS = 7;

	@Test
	void framesInWhichTheFilamentIsWoundUpDoNotCount() {
		final StrandLight light = light(List.of(0.0, 3.0, 6.0, 9.0, 66.0, 69.0, 72.0));
		assertTrue(light.open());
		for (int t = 0; t < 7; t++)
			assertEquals(t < 4, light.light()[t] > 0, "frame " + t);
	}

	@Test
	void withTooFewOpenFramesAllCount() {
		final StrandLight light = light(List.of(0.0, 3.0, 66.0, 69.0, 72.0));
		assertFalse(light.open());
		for (final double l : light.light())
			assertTrue(l > 0);
	}

	private static StrandLight light(final List<Double> wound) {
		final List<Chain> chains = wound.stream().map(w -> DrawnMovie.winding(w, LENGTH, RADIUS))
			.toList();
		final DrawnMovie drawn = DrawnMovie.draw(chains, List.of(),
			LineModel.uniform(LineModel.Kind.ADDITIVE, 1.6, 1), 0.03, 4);
		final List<FrameView> frames = new ArrayList<>();
		final List<CandidateSet> sets = new ArrayList<>();
		for (int t = 0; t < chains.size(); t++) {
			final var mask = new FilamentSegmenter(Segmentation.DEFAULT)
				.segment(new FrameCleaner(Cleaning.DEFAULT).clean(drawn.movie().frame(t)));
			final SkeletonGraph graph = SkeletonGraph.of(Skeletonize.thin(mask));
			frames.add(new FrameView(t + 1, new NormalizedFrame(DrawnMovie.SIZE, DrawnMovie.SIZE,
				Pixels.doubles(drawn.movie().frame(t))), mask, graph));
			sets.add(TrailCandidates.DEFAULT.generate(
				CandidateQuery.of(graph, new Point(22.4, 55.3), OptionalDouble.empty()),
				Progress.NONE));
		}
		return StrandLight.of(frames, sets);
	}
}
