package io.github.knotresolver.evaluate.like;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.DoubleUnaryOperator;

import org.junit.jupiter.api.Test;

import io.github.knotresolver.geometry.Polyline;

class MotionTest {

	private static final double WIDTH = 4;

	private static Optional<Polyline> curve(final int points, final DoubleUnaryOperator x,
		final DoubleUnaryOperator y) {
		final double[] xs = new double[points], ys = new double[points];
		for (int i = 0; i < points; i++) {
			final double s = (double) i / (points - 1);
			xs[i] = x.applyAsDouble(s);
			ys[i] = y.applyAsDouble(s);
		}
		return Optional.of(Polyline.of(xs, ys));
	}

	/** A rod of 100 px that turns about its first end. */
	private static Optional<Polyline> rod(final double angle) {
		return curve(2, s -> 100 * s * Math.cos(angle), s -> 100 * s * Math.sin(angle));
	}

	@Test
	void aTurningRodMovesMostAtItsTip() {
		final List<Optional<Polyline>> rods = new ArrayList<>();
		for (int t = 0; t < 6; t++)
			rods.add(rod(0.05 * t));
		final Motion motion = Motion.of(rods, WIDTH);
		final double chord = 200 * Math.sin(0.025);
		assertEquals(chord, motion.tipStep(), 1e-9);
		assertEquals(chord / 2, motion.contourStep(), 1e-9);
		assertEquals(0, motion.knotted());
		assertEquals(1, motion.extension(), 1e-9);
		assertEquals(1, motion.straightest(), 1e-9);
		assertEquals(0, motion.turning(), 1e-9);
	}

	@Test
	void missingFramesBreakPairs() {
		final List<Optional<Polyline>> rods = List.of(rod(0), Optional.empty(), rod(1), rod(1.1));
		assertEquals(200 * Math.sin(0.05), Motion.of(rods, WIDTH).tipStep(), 1e-9);
	}

	@Test
	void aSpiralMeetsItselfIfItsTurnsAreNearerThanTheLineIsWide() {
		for (final double gap : new double[]{3, 8}) {
			final var spiral = curve(600, s -> (20 + 2 * gap * s) * Math.cos(4 * Math.PI * s),
				s -> (20 + 2 * gap * s) * Math.sin(4 * Math.PI * s));
			final Motion motion = Motion.of(List.of(spiral, spiral), WIDTH);
			assertEquals(gap < WIDTH ? 1 : 0, motion.knotted(), "gap " + gap);
			assertEquals(2, motion.turning(), 0.1);
		}
	}

	@Test
	void aFigureOfEightCrossesItself() {
		final var eight = curve(400, s -> 60 * Math.sin(5 * s), s -> 30 * Math.sin(10 * s));
		assertEquals(1, Motion.of(List.of(eight), WIDTH).knotted());
	}

	@Test
	void likenessIsZeroForItselfAndGrowsWithTheDifference() {
		final Motion a = new Motion(5, 3, 0.2, 0.5, 0.7, 1.2);
		final Motion faster = new Motion(10, 6, 0.2, 0.5, 0.7, 1.2);
		final Motion fastest = new Motion(20, 12, 0.2, 0.5, 0.7, 1.2);
		assertEquals(0, a.unlike(a));
		assertEquals(2 * Math.pow(Math.log(2), 2), a.unlike(faster), 1e-12);
		assertTrue(a.unlike(faster) < a.unlike(fastest));
		assertEquals(a.unlike(faster), faster.unlike(a), 1e-12);
	}
}
