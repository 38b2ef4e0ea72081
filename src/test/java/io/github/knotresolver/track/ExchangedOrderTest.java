package io.github.knotresolver.track;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;

import java.util.ArrayList;
import java.util.List;

import org.junit.jupiter.api.Test;

import io.github.knotresolver.fit.Chain;
import io.github.knotresolver.fit.Fit;

class ExchangedOrderTest {

	private static final double SIGMA = 3.2;
	private static final double NONE = Double.NaN;

	/** Frames in which the other order costs so much more; none where there is no other. */
	private static boolean[] guessed(final Chain other, final double... more) {
		final Fit crossing = new Fit(StrandExchangeTest.coil(14, true, false), 0, 1, 1);
		final List<List<Fit>> pools = new ArrayList<>();
		for (final double m : more)
			pools.add(Double.isNaN(m)
				? List.of(crossing)
				: List.of(crossing, new Fit(other, 0, 1 + m, 1)));
		return ExchangedOrder.guessed(
			new TrellisPath(new int[more.length], new double[more.length][2], 0), pools, SIGMA);
	}

	private static Chain touching() {
		return StrandExchangeTest.coil(14, false, false);
	}

	@Test
	void framesThatAreCheaperInAnotherOrderDoubtAllThatFollowEachOther() {
		assertArrayEquals(new boolean[]{false, true, true, true, false, false},
			guessed(touching(), NONE, 2, -1, 3, NONE, 1));
		assertArrayEquals(new boolean[]{false, false, true}, guessed(touching(), 1, NONE, -0.6));
	}

	@Test
	void oneFrameOfALongRowIsChance() {
		assertArrayEquals(new boolean[5], guessed(touching(), 1, -3, 1, 1, 1));
		assertArrayEquals(new boolean[]{true, true, true, true}, guessed(touching(), 1, -3, 1, 1));
	}

	@Test
	void nothingIsDoubtedWhereNoFrameIsClearlyCheaper() {
		assertArrayEquals(new boolean[]{false, false}, guessed(touching(), 0.1, -0.2));
	}

	@Test
	void whereMostFramesAreALittleCheaperTheOrderIsAGuess() {
		assertArrayEquals(new boolean[]{true, true, true, false, false},
			guessed(touching(), 0.1, -0.1, -0.2, NONE, 0.1));
	}

	@Test
	void aContourThatLiesElsewhereIsNoOtherOrder() {
		final Chain aside = StrandExchangeTest.coil(14, true, false).shifted(4, 4);
		assertArrayEquals(new boolean[]{false, false}, guessed(aside, -1, -5));
	}

	@Test
	void aFrameWithoutContourEndsARow() {
		final Fit one = new Fit(StrandExchangeTest.coil(14, true, false), 0, 1, 1),
			other = new Fit(touching(), 0, 0, 1);
		assertArrayEquals(new boolean[]{true, false},
			ExchangedOrder.guessed(new TrellisPath(new int[]{0, -1}, new double[2][2], 0),
				List.of(List.of(one, other), List.of()), SIGMA));
	}
}
