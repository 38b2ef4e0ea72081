package io.github.knotresolver.track;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

import org.junit.jupiter.api.Test;

import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.model.FrameStatus;
import io.github.knotresolver.model.Observation;

class TipBesideTest {

	private static final double SIGMA = 1.5, NOISY = 0.3, TRIPLED = 5 / 3.0;

	private static double confidence(final double gap, final double noise, final double wrong) {
		return TipBeside.ofLine(SIGMA).doubted(List.of(spiral(gap)), noise, wrong).get(0)
			.confidence();
	}

	@Test
	void aTipThatRunsAlongTheFilamentInNoiseIsDoubted() {
		final List<Observation> frames = List.of(spiral(2.5));
		final Observation doubted = TipBeside.ofLine(SIGMA).doubted(frames, NOISY, TRIPLED).get(0);
		assertEquals(0.5, doubted.confidence());
		assertTrue(doubted.reason().contains("within the width"));
		assertEquals(frames.get(0).contour(), doubted.contour());
	}

	@Test
	void oneThatIsFartherFromItOrCrossesItIsNot() {
		assertEquals(0.99, confidence(8, NOISY, TRIPLED));
		final List<Observation> crossing = new ArrayList<>();
		crossing.add(observation(Polyline.of(new double[]{0, 20, 40, 40, 20, 20, 20},
			new double[]{0, 0, 0, 20, 20, 10, -5})));
		assertEquals(crossing, TipBeside.ofLine(SIGMA).doubted(crossing, NOISY, TRIPLED));
	}

	@Test
	void whereLightTellsOrTheLineIsNarrowItIsBelieved() {
		assertEquals(0.99, confidence(2.5, 0.02, TRIPLED));
		assertEquals(0.99, confidence(2.5, NOISY, 5));
	}

	/** A turn and a half, each turn this much farther out than the one before. */
	private static Observation spiral(final double gap) {
		final int n = 200;
		final double[] x = new double[n], y = new double[n];
		for (int i = 0; i < n; i++) {
			final double turn = 1.5 * i / n, radius = 20 + gap * turn;
			x[i] = radius * Math.cos(2 * Math.PI * turn);
			y[i] = radius * Math.sin(2 * Math.PI * turn);
		}
		return observation(Polyline.of(x, y));
	}

	private static Observation observation(final Polyline contour) {
		return new Observation(1, FrameStatus.RESOLVED, "", Optional.of(contour), 0, 1, 0, 0.99);
	}
}
