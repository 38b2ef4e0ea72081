
package io.github.knotresolver.track;

import java.util.ArrayList;
import java.util.List;

import io.github.knotresolver.fit.Chain;
import io.github.knotresolver.geometry.RobustStatistics;
import io.github.knotresolver.progress.Progress;

/**
 * Several passes become one movie: for each filament the cheapest path through what the
 * passes say of it. A vertex costs the light that its pass does not explain around any of the
 * filament's hypotheses, an edge the motion, and something more where the pass changes.
 */
final class SceneSettler {

	private final SceneLine line;
	private final SceneWeights weights;
	private final List<ScenePass> passes;
	private final List<Hypotheses> filaments;
	private final double noise;

	/**
	 * A filament.
	 *
	 * @param chains its chain in every frame
	 * @param gap how much dearer a visibly different one would be
	 * @param lengthError standard error of its length in pixels; NaN if not known
	 */
	record Settled(List<Chain> chains, double[] gap, double lengthError) {
	}

	SceneSettler(final SceneLine line, final SceneWeights weights, final List<ScenePass> passes) {
		this.line = line;
		this.weights = weights;
		this.passes = passes;
		noise = line.noise();
		filaments = Hypotheses.match(passes);
	}

	List<Settled> settle(final Progress progress) {
		final int n = line.frames().size();
		final List<List<double[]>> prices = new ArrayList<>();
		filaments.forEach(f -> prices.add(new ArrayList<>()));
		for (int t = 0; t < n; t++) {
			progress.checkCancelled();
			final List<Unexplained> left = new ArrayList<>();
			for (final ScenePass pass : passes)
				left.add(new Unexplained(line.scene(t, pass.chains().get(t)), noise));
			for (int k = 0; k < filaments.size(); k++)
				prices.get(k).add(prices(filaments.get(k), t, left));
		}
		final List<Settled> settled = new ArrayList<>();
		for (int k = 0; k < filaments.size(); k++)
			settled.add(path(filaments.get(k), prices.get(k), progress));
		return settled;
	}

	/** The first pass alone; where the settled movie differs, that is no sure. */
	List<Settled> first(final List<Settled> settled) {
		final List<Settled> all = new ArrayList<>();
		for (int k = 0; k < settled.size(); k++) {
			final List<Chain> chains = filaments.get(k).passes().get(0);
			final double[] gap = settled.get(k).gap().clone();
			for (int t = 0; t < gap.length; t++)
				if (chains.get(t)
					.farthest(settled.get(k).chains().get(t)) > SceneTuning.VISIBLY_FAR)
					gap[t] = 0.5;
			all.add(new Settled(chains, gap, settled.get(k).lengthError()));
		}
		return all;
	}

	private double[] prices(final Hypotheses filament, final int t, final List<Unexplained> left) {
		final List<Chain> here = filament.at(t);
		final double[] prices = new double[here.size()];
		for (int p = 0; p < prices.length; p++)
			prices[p] = left.get(filament.pass(p)).around(here)
				+ SceneTuning.SETTLE_BENDING * weights.stiffness() * here.get(p).bending();
		return prices;
	}

	private static Settled path(final Hypotheses filament, final List<double[]> prices,
		final Progress progress) {
		final double usual = usualMotion(filament.passes().get(0));
		final TrellisPath path = Trellis.solve(prices, (t, i, u, j) -> {
			final double motion = filament.at(t).get(i).distance(filament.at(u).get(j)) / usual;
			return motion(motion) + (i == j ? 0 : SceneTuning.SETTLE_CHANGE);
		}, progress);
		final List<Chain> chains = new ArrayList<>();
		final double[] gap = new double[prices.size()];
		for (int t = 0; t < gap.length; t++) {
			final List<Chain> here = filament.at(t);
			final Chain chosen = here.get(path.choice()[t]);
			chains.add(chosen);
			gap[t] = path.gap(t, v -> here.get(v).farthest(chosen) > SceneTuning.VISIBLY_FAR);
		}
		return new Settled(chains, gap, filament.lengthError());
	}

	/** The price of moving by a multiple of what is usual. */
	static double motion(final double multiple) {
		return SceneTuning.SETTLE_MOTION * (0.2 * multiple + 0.7 * Math.max(0, multiple - 1));
	}

	/** How far a filament moves between two frames, in pixels: the median. */
	static double usualMotion(final List<Chain> chains) {
		final double[] motion = new double[Math.max(0, chains.size() - 1)];
		for (int t = 0; t < motion.length; t++)
			motion[t] = chains.get(t).distance(chains.get(t + 1));
		return Math.max(SceneTuning.SETTLE_LEAST, RobustStatistics.upperMedian(motion, 0));
	}
}
