package io.github.knotresolver.track;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import io.github.knotresolver.Drawn;
import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.geometry.Polyline;

class SharpestTurnTest {

	private static final double SIGMA = 1.5;

	/** Straight on for 40 px, round an arc by half a turn, and back. */
	private static Polyline hairpin(final double radius) {
		final List<Point> points = new ArrayList<>();
		for (int x = 0; x < 40; x++)
			points.add(new Point(x, 0));
		for (double a = -Math.PI / 2; a <= Math.PI / 2; a += 0.05)
			points.add(new Point(40 + radius * Math.cos(a), radius + radius * Math.sin(a)));
		for (int x = 39; x >= 0; x--)
			points.add(new Point(x, 2 * radius));
		return Polyline.of(points);
	}

	@Test
	void aStraightLineDoesNotTurn() {
		assertEquals(0, SharpestTurn.of(Drawn.line(0, 0, 60, 30), SIGMA), 1e-9);
	}

	@ParameterizedTest
	@ValueSource(doubles = {5, 8, 12})
	void anArcTurnsByItsCurvature(final double radius) {
		final double turn = SharpestTurn.of(hairpin(radius), SIGMA);
		assertEquals(TrackTuning.TURN_WITHIN * SIGMA / radius, turn, 0.1);
		assertEquals(0, FitEvidence.folded(turn));
	}

	@Test
	void whatTurnsBackWithinItsWidthIsFoldedWhicheverWayItRuns() {
		for (final Polyline curve : List.of(hairpin(1), hairpin(1).reversed())) {
			final double turn = SharpestTurn.of(curve, SIGMA);
			assertEquals(Math.PI, turn, 0.05);
			assertTrue(FitEvidence.folded(turn) >= 1);
		}
	}

	@Test
	void aZigzagIsNoHairpin() {
		final double turn = SharpestTurn.of(Drawn.line(0, 0, 20, 0, 22, 1, 24, -1, 26, 0, 60, 0),
			SIGMA);
		assertTrue(turn < TrackTuning.HARMLESS_TURN, turn + "");
	}

	@Test
	void whatIsShorterThanALineIsWideHasNoTurn() {
		assertEquals(0, SharpestTurn.of(Drawn.line(0, 0, 2, 0, 0, 1), SIGMA));
		assertEquals(0, SharpestTurn.of(Drawn.line(0, 0), SIGMA));
	}
}
