package io.github.knotresolver.track;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import io.github.knotresolver.Drawn;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.graph.SkeletonGraph;

class UncoveredTest {

	private static final Polyline STEM = Drawn.line(5, 50, 105, 50);

	private static SkeletonGraph graph(final Polyline... curves) {
		return SkeletonGraph.of(Drawn.skeleton(110, 100, curves));
	}

	@Test
	void whatIsRunAlongIsCoveredEvenBesideIt() {
		assertEquals(0, Uncovered.share(graph(STEM), STEM.resampled(1)), 1e-9);
		assertEquals(0, Uncovered.share(graph(STEM), Drawn.line(5, 52, 105, 52).resampled(1)),
			1e-9);
	}

	@Test
	void aBranchIsUncoveredExceptNearTheContour() {
		final SkeletonGraph t = graph(STEM, Drawn.line(55, 50, 55, 10));
		final double share = Uncovered.share(t, STEM.resampled(1));
		assertTrue(share > 0.28 && share < 0.42, "of a branch of 40 px: " + share);
		assertEquals(0,
			Uncovered.share(t, Drawn.line(5, 50, 55, 50, 55, 10, 55, 50, 105, 50).resampled(1)),
			1e-9, "a contour along all of it");
	}

	@Test
	void theOtherPartOfACurveThatIsCutShortIsUncovered() {
		final double share = Uncovered.share(graph(STEM), Drawn.line(5, 50, 55, 50).resampled(1));
		assertTrue(share > 0.8 && share < 1.05, "of the same length again: " + share);
	}

	@Test
	void objectsThatItDoesNotTouchDoNotCount() {
		final Polyline other = Drawn.line(5, 80, 105, 80);
		assertEquals(0, Uncovered.share(graph(STEM, other), STEM.resampled(1)), 1e-9);
	}

	@ParameterizedTest
	@ValueSource(longs = {1, 2, 3, 4, 5, 6})
	void longerBranchesAreMoreAndLongerContoursLess(final long seed) {
		final Random random = new Random(seed);
		final int at = 25 + random.nextInt(60);
		double before = 0;
		for (int length = 12; length < 48; length += 7) {
			final SkeletonGraph t = graph(STEM, Drawn.line(at, 50, at, 50 - length));
			final double share = Uncovered.share(t, STEM.resampled(1));
			assertTrue(share > before, "seed " + seed + ", branch of " + length);
			assertTrue(share < (length + 1) / STEM.length(), "seed " + seed + ", of " + length);
			before = share;
		}
	}
}
