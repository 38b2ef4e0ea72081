
package io.github.knotresolver.track;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;

import org.junit.jupiter.api.Test;

import io.github.knotresolver.fit.Chain;
import io.github.knotresolver.geometry.Polyline;

class HeldEndTest {

	private static final double LENGTH = 60, SPEED = 2.7;
	private static final int LINKS = 40;

	/** A filament along the x axis that ends in an arc. */
	private static Chain hook(final double radius) {
		final int n = 121;
		final double[] x = new double[n], y = new double[n];
		final double step = LENGTH / (n - 1);
		for (int i = 1; i < n; i++) {
			final double angle = Math.max(0, (i - 90) * step / radius);
			x[i] = x[i - 1] + step * Math.cos(angle);
			y[i] = y[i - 1] + step * Math.sin(angle);
		}
		return Chain.along(Polyline.of(x, y), LINKS, LENGTH);
	}

	private static boolean isHeldAtLast(final Chain shape, final Chain before) {
		return shape.tip().distanceTo(before.tip()) < 0.5;
	}

	@Test
	void oneEndStaysAndTheRestSlides() {
		final Chain before = hook(6), slid = before.slid(SPEED);
		final List<Chain> last = HeldEnd.shapes(before, SPEED).stream()
			.filter(c -> isHeldAtLast(c, before)).toList();
		assertFalse(last.isEmpty());
		for (final Chain shape : last) {
			assertEquals(LENGTH, shape.length(), 1e-9);
			assertEquals(LINKS, shape.links());
			// All but the longest piece that may buckle.
			for (int i = 0; i < LINKS - 24 / 1.5; i++)
				assertTrue(shape.polyline().point(i).distanceTo(slid.polyline().point(i)) < 0.5,
					"node " + i);
		}
	}

	@Test
	void whatIsStraightBucklesToEitherSide() {
		final Chain before = hook(1e6);
		final List<Double> sides = HeldEnd.shapes(before, SPEED).stream()
			.filter(c -> isHeldAtLast(c, before)).map(c -> c.polyline().point(LINKS - 4).y())
			.toList();
		assertTrue(sides.stream().anyMatch(y -> y > 1), sides.toString());
		assertTrue(sides.stream().anyMatch(y -> y < -1), sides.toString());
	}

	@Test
	void whatSlidesBackIsTheSameTheOtherWayRound() {
		final Chain before = hook(6);
		for (final Chain shape : HeldEnd.shapes(before, SPEED))
			assertTrue(HeldEnd.shapes(before.reversed(), -SPEED).stream()
				.anyMatch(c -> c.reversed().farthest(shape) < 1e-6));
		assertTrue(HeldEnd.shapes(before, -SPEED).stream().anyMatch(c -> isHeldAtLast(c, before)));
	}

	@Test
	void whatSlidesFartherThanAnyPieceIsNotTried() {
		// It would have to slide farther than its longest piece is long.
		assertTrue(HeldEnd.shapes(hook(6), LENGTH).isEmpty());
	}
}
