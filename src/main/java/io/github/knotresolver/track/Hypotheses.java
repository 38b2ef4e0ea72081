
package io.github.knotresolver.track;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;

import org.apache.commons.math3.stat.descriptive.moment.StandardDeviation;

import io.github.knotresolver.fit.Chain;
import io.github.knotresolver.geometry.Polyline;

/**
 * One filament as several passes saw it, always from the same end.
 *
 * @param passes for each pass that has it its chains, by frame
 * @param numbers which passes those are
 */
record Hypotheses(List<List<Chain>> passes, List<Integer> numbers) {

	/**
	 * Finds the filaments of the first pass in the others.
	 *
	 * @param passes the best first
	 * @return one for each filament of the first pass
	 */
	static List<Hypotheses> match(final List<ScenePass> passes) {
		final ScenePass first = passes.get(0);
		final List<Hypotheses> found = new ArrayList<>();
		for (int k = 0; k < first.filaments(); k++)
			found.add(new Hypotheses(new ArrayList<>(List.of(first.filament(k))),
				new ArrayList<>(List.of(0))));
		for (int p = 1; p < passes.size(); p++)
			assign(found, passes.get(p), p);
		return found;
	}

	private record Pair(int mine, int other, int agreeing, boolean reversed) {
	}

	private static void assign(final List<Hypotheses> found, final ScenePass pass,
		final int number) {
		final List<Pair> pairs = new ArrayList<>();
		for (int i = 0; i < found.size(); i++)
			for (int j = 0; j < pass.filaments(); j++) {
				final Pair pair = compare(found.get(i).passes.get(0), pass.filament(j), i, j);
				if (pair.agreeing >= SceneTuning.AGREEING)
					pairs.add(pair);
			}
		pairs.sort(Comparator.comparingInt(Pair::agreeing).reversed().thenComparingInt(Pair::mine)
			.thenComparingInt(Pair::other));
		final boolean[] taken = new boolean[found.size()], given = new boolean[pass.filaments()];
		for (final Pair p : pairs)
			if (!taken[p.mine] && !given[p.other]) {
				taken[p.mine] = true;
				given[p.other] = true;
				final Hypotheses filament = found.get(p.mine);
				final int links = filament.passes.get(0).get(0).links();
				filament.numbers.add(number);
				filament.passes.add(pass.filament(p.other).stream()
					.map(c -> p.reversed ? c.reversed() : c).map(c -> c.divided(links)).toList());
			}
	}

	private static Pair compare(final List<Chain> mine, final List<Chain> other, final int i,
		final int j) {
		int same = 0, reversed = 0;
		final double a = mine.get(0).length();
		final double b = other.get(0).length();
		if (Math.abs(a - b) <= SceneTuning.SAME_LENGTH_SHARE * Math.max(a, b)
			+ SceneTuning.SAME_LENGTH)
			for (int t = 0; t < mine.size(); t++) {
				if (mine.get(t).start().distanceTo(other.get(t).start()) > a + b)
					continue;
				final Polyline p = mine.get(t).polyline(), q = other.get(t).polyline();
				if (SceneSeed.oneWay(p, q) < SceneTuning.SAME_CURVE)
					same++;
				else if (SceneSeed.oneWay(p, q.reversed()) < SceneTuning.SAME_CURVE)
					reversed++;
			}
		return new Pair(i, j, Math.max(same, reversed), reversed > same);
	}

	/** Standard error of the length from the lengths of the passes, in pixels; NaN for one. */
	double lengthError() {
		final double[] lengths = passes.stream().mapToDouble(p -> p.get(0).length()).toArray();
		return lengths.length < 2
			? Double.NaN
			: new StandardDeviation().evaluate(lengths) / Math.sqrt(lengths.length);
	}

	/** The number of the pass that a hypothesis is from. */
	int pass(final int hypothesis) {
		return numbers.get(hypothesis);
	}

	/** What the passes give in a frame. */
	List<Chain> at(final int t) {
		return passes.stream().map(p -> p.get(t)).toList();
	}
}
