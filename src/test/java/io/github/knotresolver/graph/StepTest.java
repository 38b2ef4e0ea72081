package io.github.knotresolver.graph;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;

import org.junit.jupiter.api.Test;

import io.github.knotresolver.Drawn;
import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.geometry.Polyline;

class StepTest {

	/** Right for 60 pixels, then down for 60. */
	private static Segment corner() {
		return SkeletonGraph
			.of(Drawn.skeleton(90, 90, Drawn.line(10, 20, 70, 20, 70, 80)), 0, List.of()).segments()
			.get(0);
	}

	private static void assertNear(final double x, final double y, final Point p) {
		assertEquals(x, p.x(), 0.05);
		assertEquals(y, p.y(), 0.05);
	}

	@Test
	void stepRunsAlongItsSegmentOrAgainstIt() {
		final Segment segment = corner();
		final boolean rightFirst = segment.source().position().x() < 15;
		final Step there = new Step(segment, rightFirst), back = new Step(segment, !rightFirst);
		assertNear(10, 20, there.from().position());
		assertNear(70, 80, there.to().position());
		assertNear(70, 80, back.from().position());
		assertNear(10, 20, back.to().position());
		assertNear(1, 0, there.departure());
		assertNear(0, 1, there.arrival());
		assertNear(0, -1, back.departure());
		assertNear(-1, 0, back.arrival());
		for (final Polyline line : List.of(there.chain(), there.curve())) {
			assertNear(10, 20, line.point(0));
			assertNear(70, 80, line.point(line.size() - 1));
		}
		for (final Polyline line : List.of(back.chain(), back.curve())) {
			assertNear(70, 80, line.point(0));
			assertNear(10, 20, line.point(line.size() - 1));
		}
		assertEquals(119, there.length(), 1.5);
		assertEquals(there.length(), back.length());
		assertTrue(there.isReverseOf(back) && back.isReverseOf(there));
		assertFalse(there.isReverseOf(there));
		assertFalse(there.isReverseOf(new Step(corner(), !rightFirst)));
	}

	@Test
	void segmentIsItselfAndTellsItsEnds() {
		final Segment segment = corner();
		assertEquals(segment, segment);
		assertNotEquals(segment, corner());
		assertEquals(segment.id(), segment.hashCode());
		assertFalse(segment.isLoop());
		assertTrue(
			segment.toString().startsWith("Segment " + segment.id() + " from node "
				+ segment.source().id() + " to node " + segment.target().id() + ", 1"),
			segment.toString());
		final Segment ring = SkeletonGraph
			.of(Drawn.skeleton(90, 90, Drawn.line(20, 20, 70, 20, 70, 70, 20, 70, 20, 20)), 0,
				List.of())
			.segments().get(0);
		assertTrue(ring.isLoop());
	}
}
