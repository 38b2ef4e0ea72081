package io.github.knotresolver.graph;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Optional;

import org.junit.jupiter.api.Test;

import io.github.knotresolver.Drawn;
import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.graph.FilamentDigraph.Label;

class FilamentDigraphTest {

	/** A filament that comes from the left, loops once and leaves to the right. */
	private final SkeletonGraph loop = SkeletonGraph.of(
		Drawn.skeleton(80, 40, Drawn.line(2, 30, 40, 30, 55, 15, 40, 3, 25, 15, 40, 30, 75, 30)));

	private Segment endingAt(final double x) {
		return loop.segments().stream().filter(s -> s.source().position().equals(new Point(x, 30))
			|| s.target().position().equals(new Point(x, 30))).findFirst().orElseThrow();
	}

	@Test
	void edgesGoBothWaysExceptAtStartAndEnd() {
		final FilamentDigraph d = FilamentDigraph.of(loop, endingAt(2), Optional.of(endingAt(75)));
		assertEquals(4, d.labels().size());
		assertEquals(0, d.asGraph().inDegreeOf(d.start()));
		assertEquals(1, d.asGraph().outDegreeOf(d.start()));
		assertEquals(1, d.asGraph().inDegreeOf(d.end().orElseThrow()));
		assertEquals(0, d.asGraph().outDegreeOf(d.end().orElseThrow()));
		final Label looping = d.labels().stream()
			.filter(l -> l.filament().filter(Segment::isLoop).isPresent()).findFirst()
			.orElseThrow();
		final Label junction = d.labels().get(0);
		assertTrue(junction.branch().isPresent());
		assertEquals(2, d.asGraph().getAllEdges(junction, looping).size());
		assertEquals(2, d.asGraph().getAllEdges(looping, junction).size());
		assertEquals(6, d.asGraph().edgeSet().size());
	}

	@Test
	void withoutEndNothingIsClosed() {
		final FilamentDigraph d = FilamentDigraph.of(loop, endingAt(2), Optional.empty());
		assertTrue(d.end().isEmpty());
		assertEquals(7, d.asGraph().edgeSet().size());
	}
}
