
package io.github.knotresolver.fit;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class GlidingTest {

	/** A filament on a circle of 30 px: sliding turns it around the centre. */
	private static Chain onCircle(final double from) {
		final double radius = 30, link = 3;
		final double turn = 2 * Math.asin(link / 2 / radius);
		final double[] theta = new double[25];
		for (int i = 0; i < theta.length; i++)
			theta[i] = from + Math.PI / 2 + (i + 0.5) * turn;
		return new Chain(50 + radius * Math.cos(from), 50 + radius * Math.sin(from), theta, link);
	}

	@ParameterizedTest
	@ValueSource(doubles = {-5, -1.3, 0, 0.4, 3, 7.7})
	void aFilamentSlidesAlongItsOwnTrack(final double by) {
		final Chain slid = onCircle(0).slid(by), there = onCircle(by / 30);
		// The end that leads goes straight on, away from the circle.
		double most = 0;
		for (int i = 4; i < 21; i++)
			most = Math.max(most, slid.polyline().point(i).distanceTo(there.polyline().point(i)));
		assertTrue(most < 0.2, "off by " + most);
		assertEquals(onCircle(0).length(), slid.length(), 1e-12);
	}

	@Test
	void howFarItSlidIsMeasured() {
		final Chain here = onCircle(0);
		assertEquals(3, here.slide(onCircle(3.0 / 30)), 0.05);
		assertEquals(-2, here.slide(onCircle(-2.0 / 30)), 0.05);
	}

	@Test
	void aReversedChainCoversTheSameNodes() {
		final Chain here = onCircle(0.3);
		final Chain back = here.reversed();
		for (int i = 0; i <= here.links(); i++)
			assertTrue(here.polyline().point(i)
				.distanceTo(back.polyline().point(here.links() - i)) < 1e-9);
		assertTrue(back.reversed().distance(here) < 1e-9);
	}
}
