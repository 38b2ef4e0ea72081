package io.github.knotresolver.graph;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;

import org.junit.jupiter.api.Test;

import io.github.knotresolver.Drawn;
import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.graph.Node.Kind;

class RootedGraphTest {

	private static final SkeletonGraph LINE = SkeletonGraph
		.of(Drawn.skeleton(70, 20, Drawn.line(5, 10, 60, 10)));

	@Test
	void freeEndNearTheFixedEndIsTheRoot() {
		final RootedGraph rooted = RootedGraph.of(LINE, new Point(2, 9));
		assertSame(LINE, rooted.graph());
		assertEquals(List.of(new Point(5, 10)),
			rooted.roots().stream().map(Node::position).toList());
	}

	@Test
	void strandAboveTheFixedEndIsDivided() {
		final RootedGraph rooted = RootedGraph.of(LINE, new Point(30, 11));
		final Node root = rooted.roots().get(0);
		assertEquals(Kind.ANCHOR, root.kind());
		assertEquals(new Point(30, 10), root.position());
		assertEquals(2, rooted.graph().stepsFrom(root).size());
		assertEquals(LINE.length(), rooted.graph().length(), 1e-9);
	}

	@Test
	void junctionAtTheFixedEndIsTheRoot() {
		final SkeletonGraph g = SkeletonGraph
			.of(Drawn.skeleton(70, 50, Drawn.line(5, 10, 60, 10), Drawn.line(30, 10, 30, 45)));
		final RootedGraph rooted = RootedGraph.of(g, new Point(30, 9));
		assertSame(g, rooted.graph());
		assertTrue(rooted.roots().get(0).isJunction());
	}

	@Test
	void allFreeEndsNearAreRootsTheNearestFirst() {
		final SkeletonGraph g = SkeletonGraph
			.of(Drawn.skeleton(70, 40, Drawn.line(5, 10, 60, 10), Drawn.line(10, 17, 60, 30)));
		assertEquals(List.of(new Point(5, 10), new Point(10, 17)),
			RootedGraph.of(g, new Point(4, 11)).roots().stream().map(Node::position).toList());
	}

	@Test
	void thinningHidesTheFixedEnd() {
		assertEquals(3, RootedGraph.of(LINE, new Point(2, 10)).hidden(new Point(2, 10)), 1e-9);
		assertEquals(5, RootedGraph.of(LINE, new Point(-3, 10)).hidden(new Point(-3, 10)), 1e-9);
		assertEquals(0, RootedGraph.of(LINE, new Point(30, 12)).hidden(new Point(30, 12)));
	}

	@Test
	void emptyGraphHasNoRoots() {
		assertTrue(RootedGraph.of(SkeletonGraph.of(Drawn.skeleton(5, 5)), new Point(2, 2)).roots()
			.isEmpty());
	}
}
