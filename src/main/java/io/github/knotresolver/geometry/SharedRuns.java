package io.github.knotresolver.geometry;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

import io.github.knotresolver.geometry.Crossings.Crossing;

/**
 * The pieces that two strands of a curve share, from a single node up to many
 * links, and whether the strands change sides there.
 */
final class SharedRuns {

	private final NodedCurve curve;
	private final List<Crossing> found = new ArrayList<>();

	SharedRuns(final NodedCurve curve) {
		this.curve = curve;
	}

	/** @return all crossings at nodes, each once */
	List<Crossing> crossings() {
		final Map<Point, List<Integer>> visits = new HashMap<>();
		for (int i = 0; i < curve.size(); i++)
			visits.computeIfAbsent(curve.node(i), p -> new ArrayList<>()).add(i);
		for (int i = 1; i < curve.size() - 1; i++)
			for (final int j : visits.get(curve.node(i)))
				if (j > i)
					look(i, j);
		return found;
	}

	/** Two visits of one node; a run is looked at from its first node only. */
	private void look(final int i, final int j) {
		if (same(i - 1, j - 1) || same(i - 1, j + 1))
			return;
		final int step = same(i + 1, j + 1) ? 1 : same(i + 1, j - 1) ? -1 : 0;
		int n = 0;
		while (step != 0 && same(i + n + 1, j + step * (n + 1)))
			n++;
		final int before = step < 0 ? j + 1 : j - 1, after = step < 0 ? j - n - 1 : j + n + 1;
		// Back along itself: the strands are the two sides of one fold.
		final boolean folds = step <= 0 && j - n - (i + n) <= 2;
		if (folds || i + n + 1 >= curve.size() || before < 0 || after < 0
			|| Math.max(before, after) >= curve.size())
			return;
		if (n == 0 ? separates(i, before, after) : exchanges(i, i + n, before, after))
			found.add(new Crossing(curve.place(i + n / 2), curve.node(i + n / 2)));
	}

	private boolean same(final int i, final int j) {
		return i >= 0 && j >= 0 && i < curve.size() && j < curve.size() && i != j
			&& curve.node(i).equals(curve.node(j));
	}

	/** Whether one strand's neighbours lie on different sides of the other strand. */
	private boolean separates(final int i, final int before, final int after) {
		return turnsLeft(i, i + 1, before, i - 1) != turnsLeft(i, i + 1, after, i - 1);
	}

	/** Whether the strand that comes in on the left goes out on the right. */
	private boolean exchanges(final int first, final int last, final int before, final int after) {
		return turnsLeft(first, first + 1, first - 1, before) == turnsLeft(last, last - 1, last + 1,
			after);
	}

	/**
	 * Whether, turning around node {@code centre} from {@code from} with growing
	 * angle, {@code first} comes before {@code second}.
	 */
	private boolean turnsLeft(final int centre, final int from, final int first, final int second) {
		final Point o = curve.node(centre), a = curve.node(from);
		final int half = half(o, a, curve.node(first)), other = half(o, a, curve.node(second));
		return half != other
			? half < other
			: Orientation.of(o, curve.node(first), curve.node(second)) > 0;
	}

	/** 0 along a, 1 in the first half turn from there, 2 opposite to a, 3 in the second. */
	private static int half(final Point o, final Point a, final Point p) {
		final int side = Orientation.of(o, a, p);
		if (side != 0)
			return side > 0 ? 1 : 3;
		final boolean along = (a.x() - o.x()) * (p.x() - o.x()) > 0
			|| (a.y() - o.y()) * (p.y() - o.y()) > 0;
		return along ? 0 : 2;
	}
}
