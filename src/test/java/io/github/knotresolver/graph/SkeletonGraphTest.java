package io.github.knotresolver.graph;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;

import net.imglib2.img.array.ArrayImgs;

import org.junit.jupiter.api.Test;

import io.github.knotresolver.Ascii;
import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.graph.Node.Kind;

class SkeletonGraphTest {

	private static SkeletonGraph graph(final String rows) {
		return SkeletonGraph.of(Ascii.mask(rows), 0, List.of());
	}

	@Test
	void plainFilamentIsOneSegment() {
		final SkeletonGraph g = graph("""
			#.........
			.##.......
			...####...
			.......##.
			.........#""");
		assertTrue(g.isUnbranched());
		assertEquals(List.of(new Point(0, 0), new Point(9, 4)),
			g.nodes().stream().map(Node::position).toList());
		assertEquals(10, g.segments().get(0).chain().size());
		assertEquals(Math.hypot(9, 4), g.length(), 0.3);
	}

	@Test
	void emptySkeletonAndDustHaveNoNodes() {
		assertTrue(graph("...\n...").nodes().isEmpty());
		assertTrue(graph("...\n.#.\n...").nodes().isEmpty());
		assertTrue(graph("....\n.##.\n.##.\n....").nodes().isEmpty());
	}

	@Test
	void closedRingIsOneNodeWithLoop() {
		final SkeletonGraph g = graph("""
			....####....
			..##....##..
			.#........#.
			.#........#.
			#..........#
			#..........#
			#..........#
			.#........#.
			.#........#.
			..##....##..
			....####....""");
		assertEquals(1, g.nodes().size());
		assertEquals(Kind.RING, g.nodes().get(0).kind());
		assertTrue(g.segments().get(0).isLoop());
		assertEquals(2, g.stepsFrom(g.nodes().get(0)).size());
		assertEquals(31, g.segments().get(0).chain().size());
		assertEquals(Math.PI * 10.5, g.length(), 2);
	}

	@Test
	void tipOnFilamentClosesLoop() {
		final SkeletonGraph g = graph("""
			..#####...
			.#.....#..
			.#......#.
			.#......#.
			.#......#.
			..#....#..
			...####...
			...#......
			...#......
			...#......""");
		assertEquals(1, g.junctions());
		assertEquals(1, g.freeEnds().size());
		assertEquals(2, g.segments().size());
		assertEquals(1, g.segments().stream().filter(Segment::isLoop).count());
		assertEquals(g.asGraph()
			.degreeOf(g.nodes().stream().filter(Node::isJunction).findFirst().orElseThrow()), 3);
	}

	@Test
	void tipThatJustTouchesMakesJunctionAndOneThatDoesNotMakesNone() {
		final String touching = """
			..........
			.########.
			.....#....
			.....#....
			.....#....""";
		assertEquals(1, graph(touching).junctions());
		assertEquals(3, graph(touching).segments().size());
		final SkeletonGraph apart = graph(
			touching.replaceFirst("\\.\\.\\.\\.\\.#\\.\\.\\.\\.", ".........."));
		assertEquals(0, apart.junctions());
		assertEquals(2, apart.segments().size());
		assertFalse(apart.isUnbranched());
	}

	@Test
	void parallelOverlapIsOneSegmentBetweenTwoJunctions() {
		final SkeletonGraph g = graph("""
			#............#
			.#..........#.
			..#........#..
			...########...
			..#........#..
			.#..........#.
			#............#""");
		assertEquals(2, g.junctions());
		assertEquals(4, g.freeEnds().size());
		assertEquals(5, g.segments().size());
		final Segment zipped = g.segments().stream()
			.filter(s -> s.source().isJunction() && s.target().isJunction()).findFirst()
			.orElseThrow();
		assertEquals(7, zipped.length(), 2.1);
	}

	@Test
	void crossingOfForeignFilamentHasFourArms() {
		final SkeletonGraph g = graph("""
			#.......#
			.#.....#.
			..#...#..
			...#.#...
			....#....
			...#.#...
			..#...#..
			.#.....#.
			#.......#""");
		assertEquals(1, g.junctions());
		final Node crossing = g.nodes().stream().filter(Node::isJunction).findFirst().orElseThrow();
		assertEquals(new Point(4, 4), crossing.position());
		assertEquals(4, g.stepsFrom(crossing).size());
		assertEquals(4 * Math.hypot(4, 4), g.length(), 1e-9);
	}

	@Test
	void severalLoopsAreParallelSegments() {
		final SkeletonGraph g = graph("""
			....###......###....
			...#...#....#...#...
			..#.....#..#.....#..
			##.......##.......##
			..#.....#..#.....#..
			...#...#....#...#...
			....###......###....""");
		assertEquals(6, g.segments().size());
		assertEquals(3, g.junctions());
		assertEquals(2, g.freeEnds().size());
		for (final Node a : g.nodes())
			for (final Node b : g.nodes())
				if (a.isJunction() && b.isJunction() && a.id() < b.id())
					assertTrue(g.asGraph().getAllEdges(a, b).size() != 1,
						"arcs of a loop are parallel");
	}

	@Test
	void notchOfJunctionIsNoLoop() {
		final SkeletonGraph g = graph("""
			..........
			....##....
			####..####
			....##....
			..........""");
		assertEquals(4,
			g.segments().size() + (g.segments().stream().anyMatch(Segment::isLoop) ? 99 : 0));
	}

	@Test
	void singlePixelJoinsTwoJunctions() {
		final SkeletonGraph g = graph("""
			#.....#
			.#...#.
			..###..
			.#...#.
			#.....#""");
		assertEquals(2, g.junctions());
		assertEquals(5, g.segments().size());
		final Segment bridge = g.segments().stream()
			.filter(x -> x.source().isJunction() && x.target().isJunction()).findFirst()
			.orElseThrow();
		assertEquals(List.of(new Point(2, 2), new Point(3, 2), new Point(4, 2)),
			List.of(bridge.chain().point(0), bridge.chain().point(1), bridge.chain().point(2)));
	}

	@Test
	void branchPixelsThatTouchAreOneJunction() {
		final SkeletonGraph g = graph("""
			#....#
			.#..#.
			..##..
			.#..#.
			#....#""");
		assertEquals(1, g.junctions());
		assertEquals(4, g.segments().size());
	}

	@Test
	void shortSpurIsPrunedAndTheFilamentStaysWhole() {
		final String debris = """
			...............
			.......#.......
			.......#.......
			###############""";
		assertEquals(3, graph(debris).segments().size());
		final SkeletonGraph pruned = SkeletonGraph.of(Ascii.mask(debris), 4, List.of());
		assertTrue(pruned.isUnbranched());
		assertEquals(14, pruned.length(), 0.5);
	}

	@Test
	void spurAtTheFixedEndIsKept() {
		final String fork = """
			#..............
			.#.............
			..#############
			.#.............
			#..............
			#..............""";
		final SkeletonGraph free = SkeletonGraph.of(Ascii.mask(fork), 5, List.of());
		assertEquals(List.of(new Point(14, 2), new Point(0, 5)),
			free.freeEnds().stream().map(Node::position).toList());
		final SkeletonGraph held = SkeletonGraph.of(Ascii.mask(fork), 5,
			List.of(new Point(0, 0), new Point(0, 5)));
		assertEquals(3, held.segments().size());
	}

	@Test
	void badInputIsNamed() {
		assertTrue(assertThrows(IllegalArgumentException.class,
			() -> SkeletonGraph.of(Ascii.mask("#"), -1, List.of())).getMessage().contains("-1.0"));
		assertTrue(assertThrows(IllegalArgumentException.class,
			() -> SkeletonGraph.of(ArrayImgs.bits(2, 2, 2))).getMessage()
			.contains("two dimensions"));
	}
}
