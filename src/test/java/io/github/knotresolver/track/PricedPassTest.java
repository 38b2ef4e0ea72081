
package io.github.knotresolver.track;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;

import org.junit.jupiter.api.Test;

import io.github.knotresolver.Drawn;
import io.github.knotresolver.fit.Chain;

class PricedPassTest {

	private static final int FRAMES = 40;

	/** A pass that explains the first frames, and leaves so much light in the others. */
	private static PricedPass pass(final int filaments, final int explained, final double left) {
		final Chain chain = Chain.inScene(Drawn.line(10, 10, 60, 10), 50);
		final double[] all = new double[FRAMES];
		Arrays.fill(all, explained, FRAMES, left);
		return new PricedPass(
			new ScenePass(0, Collections.nCopies(FRAMES, Collections.nCopies(filaments, chain))),
			all, new boolean[filaments][FRAMES]);
	}

	private static PricedPass best(final PricedPass... passes) {
		final List<PricedPass> sorted = new ArrayList<>(List.of(passes));
		PricedPass.sort(sorted);
		return sorted.get(0);
	}

	@Test
	void whereNothingCanBeFollowedThereIsNoPass() {
		final List<PricedPass> none = new ArrayList<>();
		PricedPass.sort(none);
		assertTrue(none.isEmpty());
	}

	@Test
	void lessLightIsLeftByTheBetterPass() {
		final PricedPass cheaper = pass(2, 20, 8);
		assertSame(cheaper, best(pass(2, 20, 9), cheaper));
	}

	@Test
	void aWrongLengthThatExplainsNoFrameIsNotBetterThanOneThatGetsLost() {
		final PricedPass lost = pass(1, 20, 30);
		assertSame(lost, best(pass(1, 0, 12), lost));
	}

	@Test
	void whatOneFilamentExplainsIsNotTwoPieces() {
		final PricedPass whole = pass(1, 18, 30);
		assertSame(whole, best(pass(2, 20, 15), whole));
	}

	@Test
	void aFilamentThatIsMissingIsMissedInMostFrames() {
		final PricedPass all = pass(3, 30, 8);
		assertSame(all, best(pass(2, 15, 20), all));
	}

	@Test
	void aPassThatExplainsAllIsRightHoweverManyFilamentsItHas() {
		final PricedPass all = pass(2, FRAMES, 0);
		assertSame(all, best(all, pass(1, 34, 25)));
	}

	@Test
	void whatIsSettledTogetherExplainsWhatTheFirstLeaves() {
		final PricedPass first = pass(2, 20, 8), same = pass(2, 20, 9);
		final double[] left = new double[FRAMES];
		Arrays.fill(left, 0, 20, 30);
		final PricedPass rest = new PricedPass(first.pass(), left, first.clear());
		assertEquals(List.of(first, rest, same), PricedPass.together(List.of(first, same, rest)));
	}

	@Test
	void whatExplainsAllIsSettledAlone() {
		final PricedPass all = pass(2, FRAMES, 0);
		assertEquals(List.of(all), PricedPass.together(List.of(all, pass(2, 20, 8))));
	}
}
