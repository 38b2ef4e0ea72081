package io.github.knotresolver.session;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;

import net.imglib2.Cursor;
import net.imglib2.img.Img;
import net.imglib2.type.logic.BitType;
import net.imglib2.view.Views;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import io.github.knotresolver.fit.DrawnMovie;
import io.github.knotresolver.fit.LineModel;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.model.Movie;
import io.github.knotresolver.model.Settings;
import io.github.knotresolver.model.Tracks;
import io.github.knotresolver.options.RunOptions;
import io.github.knotresolver.progress.Progress;

class FrameSkeletonsTest {

	private static final int FRAMES = 31, JUMP = 15;

	private final DrawnMovie drawn = DrawnMovie.draw(DrawnMovie.waves(FRAMES, 70, 0.8), List.of(),
		LineModel.uniform(LineModel.Kind.ADDITIVE, 1.6, 1), 0.06, 5);

	@ParameterizedTest
	@ValueSource(strings = {"both", "threshold", "active-contour"})
	void everyWayFindsAFilamentThatMovesSlowly(final String steps) {
		final List<Img<BitType>> skeletons = skeletons(drawn.movie(), steps);
		assertEquals(FRAMES, skeletons.size());
		for (int t = 0; t < FRAMES; t++)
			assertTrue(share(skeletons.get(t), drawn.truth().get(t)) > 0.9,
				steps + ", frame " + (t + 1));
	}

	@Test
	void theContourAloneLosesAFilamentThatJumps() {
		final Movie fast = new Movie("fast", Views.subsample(drawn.movie().frames(), 1, 1, JUMP),
			drawn.movie().calibration());
		final Polyline truth = drawn.truth().get(JUMP);
		assertTrue(share(skeletons(fast, "threshold").get(1), truth) > 0.9);
		assertTrue(share(skeletons(fast, "active_contour").get(1), truth) < 0.7);
	}

	@ParameterizedTest
	@ValueSource(strings = {"threshold", "active-contour"})
	void baselinesRunThroughThePipeline(final String steps) {
		final Tracks result = new Session(drawn.movie(), parameters(drawn.movie(), steps))
			.solve(List.of(), Progress.NONE);
		assertEquals(FRAMES, result.resolved());
	}

	private static List<Img<BitType>> skeletons(final Movie movie, final String steps) {
		return FrameSkeletons.of(movie, parameters(movie, steps), Progress.NONE);
	}

	private static Settings parameters(final Movie movie, final String steps) {
		return RunOptions.parse(Map.of("segmentation", steps, "candidates", "paper", "resolver",
			"paper", "refine", "no", "fixed_end", "22,55")).parameters(movie);
	}

	/** Share of the truth, a point every pixel, that has a skeleton within 2 px. */
	private static double share(final Img<BitType> skeleton, final Polyline truth) {
		final List<long[]> pixels = new ArrayList<>();
		final Cursor<BitType> pixel = skeleton.localizingCursor();
		while (pixel.hasNext())
			if (pixel.next().get())
				pixels.add(pixel.positionAsLongArray());
		final Polyline points = truth.resampled(1);
		int found = 0;
		for (int i = 0; i < points.size(); i++) {
			final double x = points.x(i), y = points.y(i);
			if (pixels.stream().anyMatch(p -> Math.hypot(p[0] - x, p[1] - y) <= 2))
				found++;
		}
		return (double) found / points.size();
	}
}
