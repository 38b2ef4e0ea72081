
package io.github.knotresolver.candidate;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

import io.github.knotresolver.geometry.Point;

/**
 * Which of the arms that meet at a junction belong together: the pairs that turn least, all
 * of them taken together. An arm may stay alone, for a price: a filament that ends there.
 * Exact, by branch and bound; at most {@value CandidateTuning#MOST_ARMS} arms.
 */
final class ArmPairing {

	private final double[][] price;
	private final int[] partner;
	private int[] best;
	private double bestPrice = Double.POSITIVE_INFINITY;

	/**
	 * An arm.
	 *
	 * @param end where it meets the junction
	 * @param outward unit vector in which it arrives there
	 * @param segment which segment it is the end of
	 */
	record Arm(Point end, Point outward, int segment) {
	}

	private ArmPairing(final double[][] price) {
		this.price = price;
		partner = new int[price.length];
		best = new int[price.length];
		Arrays.fill(best, -1);
	}

	/**
	 * @param arms of a junction
	 * @return for each arm the index of its partner, -1 if it is alone
	 */
	static int[] pair(final List<Arm> arms) {
		final int n = arms.size();
		final double[][] price = new double[n][n];
		for (int i = 0; i < n; i++)
			for (int j = 0; j < n; j++)
				price[i][j] = price(arms.get(i), arms.get(j));
		return pair(price);
	}

	/**
	 * @param price of every pair, symmetric
	 * @return for each index that of its partner, -1 if it is alone
	 */
	static int[] pair(final double[][] price) {
		final ArmPairing pairing = new ArmPairing(price);
		if (price.length <= CandidateTuning.MOST_ARMS) {
			final List<Integer> open = new ArrayList<>();
			for (int i = 0; i < price.length; i++)
				open.add(i);
			pairing.search(open, 0);
		}
		return pairing.best;
	}

	/** How much a filament turns that comes in by one arm and leaves by the other, 0 to 2. */
	static double price(final Arm a, final Arm b) {
		final double dx = b.end.x() - a.end.x(), dy = b.end.y() - a.end.y();
		final double distance = Math.hypot(dx, dy);
		double turn = 1 + a.outward.x() * b.outward.x() + a.outward.y() * b.outward.y();
		if (distance > CandidateTuning.ONE_PLACE) {
			final double out = (a.outward.x() * dx + a.outward.y() * dy) / distance;
			final double in = (b.outward.x() * dx + b.outward.y() * dy) / distance;
			turn = 0.5 * turn + 0.5 * (1 - out + 1 + in);
		}
		return turn + (a.segment == b.segment && distance < CandidateTuning.OWN_DISTANCE
			? CandidateTuning.OWN_END
			: 0);
	}

	private void search(final List<Integer> open, final double sofar) {
		if (sofar >= bestPrice)
			return;
		if (open.isEmpty()) {
			bestPrice = sofar;
			best = partner.clone();
			return;
		}
		final int first = open.get(0);
		final List<Integer> rest = open.subList(1, open.size());
		final List<Integer> nearest = new ArrayList<>(rest);
		nearest.sort((a, b) -> Double.compare(price[first][a], price[first][b]));
		for (final int other : nearest) {
			if (price[first][other] >= 2 * CandidateTuning.ALONE)
				break;
			final List<Integer> left = new ArrayList<>(rest);
			left.remove(Integer.valueOf(other));
			partner[first] = other;
			partner[other] = first;
			search(left, sofar + price[first][other]);
		}
		partner[first] = -1;
		search(new ArrayList<>(rest), sofar + CandidateTuning.ALONE);
	}
}
