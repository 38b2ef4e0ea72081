package io.github.knotresolver.track;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;

import org.junit.jupiter.api.Test;

import io.github.knotresolver.Drawn;
import io.github.knotresolver.fit.Chain;
import io.github.knotresolver.fit.LineModel;
import io.github.knotresolver.fit.LineTables;
import io.github.knotresolver.fit.NormalizedFrame;
import io.github.knotresolver.fit.Scene;

/** Straight filaments of which one lies where there is no light. */
class UnexplainedTest {

	private static final int SIZE = 100;

	private static final LineTables LINE = LineTables
		.together(LineModel.uniform(LineModel.Kind.ADDITIVE, 1.4, 1));

	private static Chain straight(final double x, final double y) {
		return Chain.along(Drawn.line(x, y, x + 60, y), 20, 60);
	}

	/** What is not explained in a picture of some chains if others are drawn. */
	private static Unexplained left(final List<Chain> seen, final List<Chain> drawn) {
		final NormalizedFrame dark = new NormalizedFrame(SIZE, SIZE, new double[SIZE * SIZE]);
		// What is drawn in the dark is too much.
		final NormalizedFrame lit = new Scene(dark, LINE, seen).residual().rescaled(0, -1);
		return new Unexplained(new Scene(lit, LINE, drawn), 0.05);
	}

	@Test
	void aFilamentThatIsRightIsDoubtfulBesideOneThatIsWrong() {
		final Chain right = straight(20, 40), wrong = straight(20, 49);
		final List<Chain> drawn = List.of(right, wrong);
		final Unexplained left = left(List.of(right), drawn);
		assertEquals(left.worst(wrong), left.worstBeside(right, drawn), 1e-12);
		assertTrue(left.worst(wrong) > 1);
		assertTrue(left.worst(right) < 0.1 * left.worst(wrong));
	}

	@Test
	void oneThatIsFarAwayIsNot() {
		final Chain right = straight(20, 40), wrong = straight(20, 55);
		final List<Chain> drawn = List.of(right, wrong);
		final Unexplained left = left(List.of(right), drawn);
		assertEquals(left.worst(right), left.worstBeside(right, drawn), 0);
	}

	@Test
	void whereAllIsExplainedNothingIsLeft() {
		final List<Chain> all = List.of(straight(20, 40), straight(20, 44));
		assertEquals(0, left(all, all).worstBeside(all.get(0), all), 1e-12);
	}
}
