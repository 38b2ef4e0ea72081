
package io.github.knotresolver.track;

import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.function.IntFunction;

import org.junit.jupiter.api.Test;

import io.github.knotresolver.fit.Chain;
import io.github.knotresolver.geometry.Polyline;

class LoneSeedsTest {

	private static final int LOOKS = 12;
	private static final double SPECK = 25;

	private static Chain rod(final double x, final double y, final double angle,
		final double length) {
		return Chain.inScene(Polyline.of(new double[]{x, x + length * Math.cos(angle)},
			new double[]{y, y + length * Math.sin(angle)}), length);
	}

	private static boolean lone(final IntFunction<List<Chain>> looks) {
		final List<SceneSeed> seeds = new ArrayList<>();
		for (int t = 0; t < LOOKS; t++) {
			final List<Chain> chains = looks.apply(t);
			seeds.add(new SceneSeed(5 * t, chains, new boolean[chains.size()], 1));
		}
		return LoneSeeds.areOfOneClamped(seeds, SPECK);
	}

	/** One that is held at (20, 50) and turns; every other one the other way round. */
	private static Chain held(final int t) {
		final Chain chain = rod(20, 50, 0.1 * t - 0.5, 60);
		return t % 2 == 0 ? chain : chain.reversed();
	}

	@Test
	void oneThatIsHeldAmongSpecksIsLone() {
		assertTrue(lone(t -> List.of(rod(90, 10 + 5 * t, 1, 12), held(t), rod(5, 5, 0, 20))));
	}

	@Test
	void someFramesMayMislead() {
		assertTrue(lone(t -> t < 3 ? List.of(held(t), rod(30, 50, 0, 30)) : List.of(held(t))));
		assertFalse(lone(t -> t < 4 ? List.of(held(t), rod(30, 50, 0, 30)) : List.of(held(t))));
	}

	@Test
	void twoAreNotOne() {
		assertFalse(lone(t -> List.of(held(t), rod(80, 20, 0.1 * t, 40))));
	}

	@Test
	void oneThatGlidesIsNotHeld() {
		assertFalse(lone(t -> List.of(rod(10 + 12 * t, 50, 0.2, 60))));
	}

	@Test
	void oneThatLiesStillIsNotKnownToBeHeld() {
		assertFalse(lone(t -> List.of(rod(10, 50, 0.01 * t, 60))));
	}
}
