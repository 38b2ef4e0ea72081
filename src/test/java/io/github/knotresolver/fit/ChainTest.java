package io.github.knotresolver.fit;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import io.github.knotresolver.Drawn;

class ChainTest {

	private static final double LENGTH = 80, RADIUS = 9;

	@ParameterizedTest
	@ValueSource(ints = {1, 4, 12})
	void windingUpAtTheBaseIsWhatAPushedFilamentDoes(final int links) {
		final Chain before = DrawnMovie.winding(30, LENGTH, RADIUS);
		final double way = links * before.linkLength();
		assertEquals(0,
			before.wound(2, links).distance(DrawnMovie.winding(30 + way, LENGTH, RADIUS)), 1e-9);
	}

	@ParameterizedTest
	@ValueSource(ints = {1, 4, 12})
	void unwindingIsTheWayBack(final int links) {
		final Chain before = DrawnMovie.winding(40, LENGTH, RADIUS);
		final double way = links * before.linkLength();
		assertEquals(0,
			before.wound(2, -links).distance(DrawnMovie.winding(40 - way, LENGTH, RADIUS)), 1e-9);
		assertEquals(0, before.wound(2, links).wound(2, -links).distance(before), 1e-9);
	}

	@Test
	void slidingKeepsEndAndLength() {
		final Chain chain = DrawnMovie.wave(3, LENGTH, 2);
		for (final int by : new int[]{-20, 7, 20}) {
			final Chain slid = chain.wound(12, by);
			assertEquals(chain.start(), slid.start());
			assertEquals(chain.length(), slid.length());
		}
	}

	@Test
	void aChainThatKeepsItsVelocityDoesNotChangeItsCourse() {
		final Chain here = Chain.along(Drawn.line(0, 0, 60, 0), 20, 60);
		assertEquals(0, here.changeOfCourse(here.shifted(-3, -1), here.shifted(3, 1)), 1e-9);
		assertEquals(10, here.changeOfCourse(here.shifted(3, 4), here.shifted(3, 4)), 1e-9);
	}

	@Test
	void whatRunsBackAlongALineIsAlongIt() {
		final Chain there = Chain.along(Drawn.line(0, 0, 60, 0), 20, 60);
		assertTrue(there.isAlong(there.reversed().shifted(0, 1), 1.01));
		assertFalse(there.isAlong(there.reversed().shifted(0, 1), 0.99));
		assertFalse(there.isAlong(Chain.along(Drawn.line(0, 0, 50, 0), 20, 50), 5));
		assertTrue(Chain.along(Drawn.line(0, 0, 50, 0), 20, 50).isAlong(there, 5));
	}
}
