package io.github.knotresolver.candidate;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Comparator;
import java.util.List;

import org.junit.jupiter.api.Test;

import io.github.knotresolver.Drawn;
import io.github.knotresolver.candidate.SceneTrails.Found;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.graph.SkeletonGraph;

/** All filaments of a drawn field, each line one filament. */
class SceneTrailsTest {

	private static Found found(final double brightness, final Polyline... curves) {
		return SceneTrails.of(SkeletonGraph.of(Drawn.skeleton(140, 100, curves), 0, List.of()),
			c -> brightness);
	}

	/** Whichever way it runs, a curve goes from one place to another, and is so long. */
	private static void assertRuns(final Polyline curve, final double fromX, final double fromY,
		final double toX, final double toY, final double length) {
		final Polyline c = Math.hypot(curve.x(0) - fromX, curve.y(0) - fromY) < 3
			? curve
			: curve.reversed();
		assertEquals(fromX, c.x(0), 2);
		assertEquals(fromY, c.y(0), 2);
		assertEquals(toX, c.x(c.size() - 1), 2);
		assertEquals(toY, c.y(c.size() - 1), 2);
		assertEquals(length, c.length(), 0.06 * length);
	}

	private static List<Polyline> longestFirst(final Found found) {
		return found.curves().stream()
			.sorted(Comparator.comparingDouble(Polyline::length).reversed()).toList();
	}

	@Test
	void linesThatDoNotMeetAreThemselves() {
		final Found f = found(1, Drawn.line(10, 10, 110, 10), Drawn.line(10, 50, 60, 50));
		assertEquals(2, f.curves().size());
		assertRuns(longestFirst(f).get(0), 10, 10, 110, 10, 100);
		assertRuns(longestFirst(f).get(1), 10, 50, 60, 50, 50);
		assertEquals(0, f.loose());
		assertEquals(0, f.crossings());
	}

	@Test
	void linesGoStraightThroughTheirCrossing() {
		final Found f = found(1, Drawn.line(10, 50, 120, 50), Drawn.line(60, 10, 60, 90));
		assertEquals(2, f.curves().size());
		assertRuns(longestFirst(f).get(0), 10, 50, 120, 50, 110);
		assertRuns(longestFirst(f).get(1), 60, 10, 60, 90, 80);
		assertEquals(0, f.loose());
		assertEquals(2, f.crossings());
	}

	/** Two junctions, a few pixels apart, are one crossing. */
	@Test
	void shortBridgeBelongsToNoLine() {
		final Found f = found(1, Drawn.line(10, 20, 60, 48, 65, 48, 115, 20),
			Drawn.line(10, 80, 60, 52, 60, 48), Drawn.line(65, 48, 65, 52, 115, 80));
		assertEquals(2, f.curves().size());
		assertEquals(0, f.loose());
		assertEquals(2, f.crossings());
		assertRuns(longestFirst(f).get(0), 10, longestFirst(f).get(0).y(0) < 50 ? 20 : 80, 115,
			longestFirst(f).get(0).y(0) < 50 ? 80 : 20, 121);
	}

	/** Two strands that lie on each other are twice as bright, and come apart behind it. */
	@Test
	void longBridgeIsCrossedOnlyIfItIsBright() {
		final Polyline[] lines = {Drawn.line(10, 20, 50, 50, 80, 50, 120, 80),
			Drawn.line(10, 80, 50, 50), Drawn.line(80, 50, 120, 20)};
		final Found bright = found(2, lines);
		assertEquals(2, bright.curves().size());
		assertEquals(0, bright.loose());
		assertEquals(2, bright.crossings());
		final Found dim = found(1, lines);
		assertEquals(3, dim.curves().size());
		assertEquals(2, dim.loose());
		assertEquals(2, dim.crossings());
		assertEquals(longestFirst(bright).get(0).length(), longestFirst(dim).get(0).length(), 6);
	}

	/** Where an end touches a line, the line goes on and the end is loose. */
	@Test
	void endThatTouchesALineIsLoose() {
		final Found f = found(1, Drawn.line(10, 50, 120, 50), Drawn.line(60, 10, 60, 50));
		assertEquals(2, f.curves().size());
		assertRuns(longestFirst(f).get(0), 10, 50, 120, 50, 110);
		assertRuns(longestFirst(f).get(1), 60, 10, 60, 50, 40);
		assertEquals(1, f.loose());
		assertEquals(1, f.crossings());
	}

	@Test
	void ringIsOneClosedTrail() {
		final Found f = found(1, Drawn.line(30, 30, 90, 30, 90, 80, 30, 80, 30, 30));
		assertEquals(1, f.curves().size());
		final Polyline ring = f.curves().get(0);
		assertEquals(220, ring.length(), 12);
		assertTrue(Math.hypot(ring.x(0) - ring.x(ring.size() - 1),
			ring.y(0) - ring.y(ring.size() - 1)) < 2);
	}

	/** A filament that crosses itself is one trail, its loop in the middle. */
	@Test
	void loopIsWalkedThrough() {
		final Found f = found(1,
			Drawn.line(10, 60, 90, 60, 110, 40, 90, 15, 60, 15, 50, 40, 50, 60, 50, 95));
		assertEquals(1, f.curves().size());
		assertEquals(2, f.crossings());
		assertRuns(f.curves().get(0), 10, 60, 50, 95, 252);
	}
}
