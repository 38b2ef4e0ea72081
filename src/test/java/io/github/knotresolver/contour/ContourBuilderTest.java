package io.github.knotresolver.contour;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;

import org.junit.jupiter.api.Test;

import io.github.knotresolver.Drawn;
import io.github.knotresolver.candidate.Candidate;
import io.github.knotresolver.candidate.Candidate.Price;
import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.graph.SkeletonGraph;
import io.github.knotresolver.graph.Step;

class ContourBuilderTest {

	private static final Polyline TRUTH = Drawn.line(5, 5, 60, 25, 90, 60);

	private static final SkeletonGraph GRAPH = SkeletonGraph.of(Drawn.skeleton(100, 70, TRUTH));

	private static Candidate whole(final boolean forward) {
		return Candidate.whole(List.of(new Step(GRAPH.segments().get(0), forward)), Price.NONE);
	}

	@Test
	void smoothContourKeepsEndsAndLengthAndIsSampledAtOnePixel() {
		final Polyline contour = ContourBuilder.smooth(whole(true));
		assertEquals(new Point(5, 5), contour.first());
		assertEquals(new Point(90, 60), contour.last());
		assertEquals(TRUTH.length(), contour.length(), 0.01 * TRUTH.length());
		for (int i = 1; i < contour.size(); i++)
			assertEquals(1, contour.point(i).distanceTo(contour.point(i - 1)), 0.02);
		assertTrue(DiscreteFrechet.distance(TRUTH.resampled(1), contour) < 1.5);
	}

	@Test
	void directionIsThatOfTheWalk() {
		final Polyline back = ContourBuilder.smooth(whole(false));
		assertEquals(new Point(90, 60), back.first());
		assertEquals(GRAPH.segments().get(0).chain().reversed(),
			ContourBuilder.pixels(whole(false)));
	}

	@Test
	void walkThatEndsInsideIsCutThere() {
		final Candidate cut = new Candidate(List.of(new Step(GRAPH.segments().get(0), true)), 40,
			Price.NONE);
		assertTrue(cut.endsInside());
		assertEquals(40, ContourBuilder.smooth(cut).length(), 0.5);
		assertTrue(ContourBuilder.smooth(cut).last().distanceTo(TRUTH.at(40)) < 1.5);
		assertEquals(40, ContourBuilder.pixels(cut).length(), 0.5);
	}

	@Test
	void candidatesAreChecked() {
		final Step step = new Step(GRAPH.segments().get(0), true);
		assertThrows(IllegalArgumentException.class, () -> new Candidate(List.of(), 1, Price.NONE));
		assertThrows(IllegalArgumentException.class,
			() -> new Candidate(List.of(step), 0, Price.NONE));
		assertTrue(assertThrows(IllegalArgumentException.class,
			() -> new Candidate(List.of(step, step), 1, Price.NONE)).getMessage()
			.contains("begins at node"));
	}
}
