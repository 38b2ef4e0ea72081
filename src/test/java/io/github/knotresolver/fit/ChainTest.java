package io.github.knotresolver.fit;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

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
}
