
package io.github.knotresolver.track;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;

import io.github.knotresolver.fit.Scene;
import io.github.knotresolver.progress.Workers;

/**
 * A pass and what it costs.
 *
 * @param pass all filaments in all frames
 * @param left the light that it does not explain in each frame, in strands squared
 * @param clear for each filament and frame whether the light around it is explained
 */
record PricedPass(ScenePass pass, double[] left, boolean[][] clear) {

	/** Looks at what a pass leaves in all frames; O(pixels frames). */
	static PricedPass of(final ScenePass pass, final SceneLine line, final Workers workers) {
		return of(pass, 0, line, workers);
	}

	/** The same of one that begins in a later frame. */
	static PricedPass of(final ScenePass pass, final int first, final SceneLine line,
		final Workers workers) {
		final int n = pass.chains().size();
		final double[] left = new double[n];
		final boolean[][] clear = new boolean[pass.filaments()][n];
		workers.map(n, t -> {
			final Scene scene = line.scene(first + t, pass.chains().get(t));
			final Unexplained unexplained = new Unexplained(scene, line.noise());
			left[t] = line.left(first + t, scene, unexplained);
			for (int k = 0; k < clear.length; k++)
				clear[k][t] = unexplained.isClear(pass.chains().get(t).get(k));
			return t;
		});
		return new PricedPass(pass, left, clear);
	}

	/** What it leaves in a frame, and a price for every filament. */
	double price() {
		return unexplained() + pass.priceOfFilaments();
	}

	/** What it leaves in a frame. */
	double unexplained() {
		return Arrays.stream(left).average().orElse(0);
	}

	/** Whether hardly any light is left in any frame. */
	boolean isClear() {
		return unexplained() < SceneTuning.CLEAR_PASS * pass.filaments();
	}

	/** In how many frames all light is explained. */
	int explained() {
		return (int) Arrays.stream(left)
			.filter(l -> l <= SceneTuning.UNCLEAR_LIGHT * pass.filaments()).count();
	}

	/**
	 * The best pass first, the others by their price. How many filaments there are, and how long,
	 * is told by the frames in which all light is explained, not by how much is left where
	 * filaments are lost: a pass with as many filaments as the cheapest that explains clearly more
	 * frames is better, and so is one with fewer that explains nearly as many.
	 *
	 * @param passes sorted in place; none stay none
	 */
	static void sort(final List<PricedPass> passes) {
		if (passes.isEmpty())
			return;
		passes.sort(Comparator.comparingDouble(PricedPass::price));
		PricedPass best = passes.get(0);
		if (best.isClear())
			return;
		for (final PricedPass p : passes)
			if (p.explained() >= SceneTuning.AGAIN_CLEAR && p.tellsMoreThan(best))
				best = p;
		passes.remove(best);
		passes.add(0, best);
	}

	/**
	 * The passes that are settled together: the first one, and as long as light is left those that
	 * explain most of what all before them leave. A pass that is lost in most frames may be the
	 * only one that is right in the others. O(passes frames).
	 *
	 * @param passes the best first, at least one
	 */
	static List<PricedPass> together(final List<PricedPass> passes) {
		final List<PricedPass> chosen = new ArrayList<>(List.of(passes.get(0)));
		final List<PricedPass> others = new ArrayList<>(passes.subList(1, passes.size()));
		double[] left = passes.get(0).left;
		while (!passes.get(0).isClear() && !others.isEmpty()
			&& chosen.size() < SceneTuning.SETTLED_PASSES) {
			final double[] until = left;
			final PricedPass next = others.stream()
				.min(Comparator.comparingDouble(p -> Arrays.stream(p.least(until)).sum()))
				.orElseThrow();
			others.remove(next);
			chosen.add(next);
			left = next.least(until);
		}
		return chosen;
	}

	/** In each frame what it leaves, or what others do if that is less. */
	private double[] least(final double[] others) {
		final double[] least = new double[left.length];
		Arrays.setAll(least, t -> Math.min(left[t], others[t]));
		return least;
	}

	private boolean tellsMoreThan(final PricedPass other) {
		return pass.filaments() == other.pass.filaments()
			? explained() >= other.explained() + SceneTuning.AGAIN_CLEAR
			: pass.filaments() < other.pass.filaments()
				&& explained() >= SceneTuning.VISIBLY_LESS * other.explained();
	}
}
