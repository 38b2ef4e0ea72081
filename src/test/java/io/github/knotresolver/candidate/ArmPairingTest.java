
package io.github.knotresolver.candidate;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Arrays;
import java.util.List;
import java.util.Random;

import org.junit.jupiter.api.Test;

import io.github.knotresolver.candidate.ArmPairing.Arm;
import io.github.knotresolver.geometry.Point;

class ArmPairingTest {

	/** The price of the cheapest pairing, by trying all. */
	private static double bruteForce(final double[][] price, final boolean[] used, final int from) {
		int first = from;
		while (first < used.length && used[first])
			first++;
		if (first == used.length)
			return 0;
		used[first] = true;
		double best = CandidateTuning.ALONE + bruteForce(price, used, first + 1);
		for (int other = first + 1; other < used.length; other++)
			if (!used[other]) {
				used[other] = true;
				best = Math.min(best, price[first][other] + bruteForce(price, used, first + 1));
				used[other] = false;
			}
		used[first] = false;
		return best;
	}

	@Test
	void findsTheCheapestPairing() {
		for (long seed = 1; seed <= 200; seed++) {
			final Random random = new Random(seed);
			final int n = 1 + random.nextInt(8);
			final double[][] price = new double[n][n];
			for (int i = 0; i < n; i++)
				for (int j = 0; j < i; j++) {
					price[i][j] = 2.5 * random.nextDouble();
					price[j][i] = price[i][j];
				}
			final int[] partner = ArmPairing.pair(price);
			double found = 0;
			for (int i = 0; i < n; i++)
				if (partner[i] < 0)
					found += CandidateTuning.ALONE;
				else {
					assertEquals(i, partner[partner[i]], "seed " + seed);
					found += price[i][partner[i]] / 2;
				}
			assertEquals(bruteForce(price, new boolean[n], 0), found, 1e-9, "seed " + seed);
		}
	}

	private static Arm arm(final double angle, final int segment) {
		final Point out = new Point(-Math.cos(angle), -Math.sin(angle));
		return new Arm(new Point(Math.cos(angle), Math.sin(angle)), out, segment);
	}

	@Test
	void strandsGoStraightOnThroughACrossing() {
		final List<Arm> arms = List.of(arm(0, 0), arm(1, 1), arm(Math.PI, 2), arm(1 + Math.PI, 3));
		assertArrayEquals(new int[]{2, 3, 0, 1}, ArmPairing.pair(arms));
	}

	private static Arm at(final double x, final double y, final double outX, final double outY,
		final int segment) {
		return new Arm(new Point(x, y), new Point(outX, outY), segment);
	}

	@Test
	void priceIsTheTurnAndBeyondOnePlaceTheWayBetween() {
		final double eps = 1e-12;
		// In one place: straight on, a right angle, and back.
		assertEquals(0, ArmPairing.price(at(1, 2, 1, 0, 0), at(3, 2, -1, 0, 1)), eps);
		assertEquals(1, ArmPairing.price(at(1, 2, 1, 0, 0), at(3, 2, 0, 1, 1)), eps);
		assertEquals(2, ArmPairing.price(at(1, 2, 1, 0, 0), at(3, 2, 1, 0, 1)), eps);
		assertEquals(1 - 0.6 * 0.8 - 0.8 * 0.6,
			ArmPairing.price(at(1, 2, 0.6, 0.8, 0), at(3, 2, -0.8, -0.6, 1)), eps);
		// Apart: half of it, and half of how far both look past each other.
		assertEquals(0, ArmPairing.price(at(1, 2, 1, 0, 0), at(11, 2, -1, 0, 1)), eps);
		assertEquals(1, ArmPairing.price(at(1, 2, 1, 0, 0), at(1, 12, -1, 0, 1)), eps);
		assertEquals(0.5 * 1 + 0.5 * (0.4 + 1.8),
			ArmPairing.price(at(1, 2, 0.6, 0.8, 0), at(11, 2, 0.8, -0.6, 1)), eps);
		assertEquals(0.5 * 1 + 0.5 * (0.2 + 0.4),
			ArmPairing.price(at(1, 2, 0.6, 0.8, 0), at(1, 12, 0.8, -0.6, 1)), eps);
	}

	@Test
	void bothEndsOfASegmentHardlyBelongTogetherWhereTheyAreNear() {
		assertEquals(CandidateTuning.OWN_END,
			ArmPairing.price(at(1, 2, 1, 0, 7), at(3, 2, -1, 0, 7)), 1e-12);
		assertEquals(CandidateTuning.OWN_END,
			ArmPairing.price(at(1, 2, 1, 0, 7), at(8.9, 2, -1, 0, 7)), 1e-12);
		assertEquals(0, ArmPairing.price(at(1, 2, 1, 0, 7), at(9, 2, -1, 0, 7)), 1e-12);
	}

	/** More arms than can be tried are left alone, all of them. */
	@Test
	void tooManyArmsAreNotPaired() {
		final int most = CandidateTuning.MOST_ARMS;
		assertEquals(1, ArmPairing.pair(new double[most][most])[0]);
		final int[] alone = new int[most + 1];
		Arrays.fill(alone, -1);
		assertArrayEquals(alone, ArmPairing.pair(new double[most + 1][most + 1]));
	}

	@Test
	void anEndThatTouchesStaysAlone() {
		final List<Arm> arms = List.of(arm(0, 0), arm(Math.PI / 2, 1), arm(Math.PI, 2));
		assertArrayEquals(new int[]{2, -1, 0}, ArmPairing.pair(arms));
	}
}
