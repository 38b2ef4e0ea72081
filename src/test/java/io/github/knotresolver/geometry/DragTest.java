package io.github.knotresolver.geometry;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;

import org.junit.jupiter.api.Test;

class DragTest {

	/** From left to right, 100 px. */
	private static final Polyline LINE = Polyline.of(List.of(new Point(0, 10), new Point(100, 10)));

	@Test
	void whatIsNearFollowsAndWhatIsFarStays() {
		final Drag drag = Drag.at(LINE, new Point(50, 12), 3).orElseThrow();
		assertFalse(drag.isOfTip());
		assertEquals(50, drag.held(), 1);
		final Polyline drawn = drag.to(new Point(50, 30));
		assertEquals(30, drawn.at(drawn.length() / 2).y(), 0.5);
		assertEquals(LINE.first(), drawn.first());
		assertEquals(LINE.last(), drawn.last());
		for (int i = 0; i < drawn.size(); i++)
			assertEquals(drawn.x(i) < 29 || drawn.x(i) > 71 ? 10 : 20, drawn.y(i),
				drawn.x(i) < 29 || drawn.x(i) > 71 ? 0.1 : 10.1);
	}

	@Test
	void theTipIsHeldWhereItIsInReachThoughTheContourIsNearer() {
		final Drag drag = Drag.at(LINE, new Point(98, 10), 3).orElseThrow();
		assertTrue(drag.isOfTip());
		final Polyline drawn = drag.to(new Point(98, 25));
		assertEquals(new Point(98, 25), drawn.last());
		assertEquals(LINE.first(), drawn.first());
	}

	@Test
	void besideTheContourNothingIsHeld() {
		assertTrue(Drag.at(LINE, new Point(50, 14), 3).isEmpty());
		assertTrue(Drag.at(LINE, new Point(-4, 10), 3).isEmpty());
	}
}
