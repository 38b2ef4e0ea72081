
package io.github.knotresolver.track;

import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.stream.DoubleStream;
import java.util.stream.Stream;

import io.github.knotresolver.fit.Chain;
import io.github.knotresolver.fit.Fit;
import io.github.knotresolver.fit.Scene;
import io.github.knotresolver.progress.Progress;
import io.github.knotresolver.track.SceneSettler.Settled;

/**
 * Two filaments that cross might be each other's halves: if both lengths allow it, the light
 * does not tell. For every two that touch, the course on which their tails are exchanged is
 * followed through all frames in which it is possible; which one is right is told by bending
 * and motion over the whole time, and how surely by how much dearer the other one is.
 */
final class TailExchanges {

	private final SceneLine line;
	private final SceneWeights weights;
	private final Progress progress;

	TailExchanges(final SceneLine line, final SceneWeights weights, final Progress progress) {
		this.line = line;
		this.weights = weights;
		this.progress = progress;
	}

	/** Two filaments in a frame with their tails exchanged, and what that costs more. */
	private record Exchanged(Chain a, Chain b, double more) {
	}

	/**
	 * The filaments, with tails exchanged where that is cheaper, and less sure where it is
	 * nearly as cheap. O(frames) for every two that touch.
	 */
	List<Settled> checked(final List<Settled> filaments) {
		final List<Settled> checked = new ArrayList<>(filaments);
		for (int i = 0; i < checked.size(); i++)
			for (int j = 0; j < i; j++) {
				progress.checkCancelled();
				check(checked, i, j);
			}
		return checked;
	}

	private void check(final List<Settled> filaments, final int i, final int j) {
		final int n = line.frames().size();
		final List<List<Exchanged>> others = new ArrayList<>();
		int possible = 0;
		for (int t = 0; t < n; t++) {
			final List<Exchanged> other = mayTouch(filaments, i, j, t)
				? exchanged(filaments, i, j, t)
				: List.<Exchanged>of();
			others.add(other);
			possible += other.isEmpty() ? 0 : 1;
		}
		if (possible >= SceneTuning.EXCHANGE_FEWEST)
			decide(filaments, i, j, others);
	}

	private boolean mayTouch(final List<Settled> filaments, final int i, final int j, final int t) {
		final Chain a = filaments.get(i).chains().get(t), b = filaments.get(j).chains().get(t);
		return a.start().distanceTo(b.start()) < a.length() + b.length()
			&& !TailSwap.exchanged(a, b, SceneTuning.EXCHANGE_LENGTH).isEmpty();
	}

	/** The best exchanges in a frame that show: of the tails, and of the heads. */
	private List<Exchanged> exchanged(final List<Settled> filaments, final int i, final int j,
		final int t) {
		final Chain a = filaments.get(i).chains().get(t), b = filaments.get(j).chains().get(t);
		final List<Chain> here = new ArrayList<>();
		for (final Settled s : filaments)
			here.add(s.chains().get(t));
		final Scene scene = line.scene(t, here);
		scene.take(i);
		scene.take(j);
		final double before = price(scene, j, a, b);
		TailSwap.Pair tails = null, heads = null;
		for (final TailSwap.Pair p : TailSwap.exchanged(a, b, SceneTuning.EXCHANGE_LENGTH)) {
			if (!shows(p.a(), a) || !shows(p.b(), b))
				continue;
			final double energy = price(scene, j, p.a(), p.b());
			final boolean keepsHeads = p.a().start().distanceTo(a.start()) < SceneTuning.END_STAYS
				&& p.b().start().distanceTo(b.start()) < SceneTuning.END_STAYS;
			final TailSwap.Pair best = keepsHeads ? tails : heads;
			if (energy >= (best == null ? before + SceneTuning.EXCHANGE_HOPELESS : best.energy()))
				continue;
			final TailSwap.Pair better = new TailSwap.Pair(p.a(), p.b(), energy);
			if (keepsHeads)
				tails = better;
			else
				heads = better;
		}
		return Stream.of(tails, heads).filter(Objects::nonNull)
			.map(p -> fitted(scene, i, j, p, before)).filter(e -> shows(e.a, a) && shows(e.b, b))
			.toList();
	}

	private static boolean shows(final Chain other, final Chain chain) {
		return other.farthest(chain) > SceneTuning.VISIBLY_FAR;
	}

	private Exchanged fitted(final Scene scene, final int i, final int j, final TailSwap.Pair start,
		final double before) {
		scene.put(j, start.b());
		final Chain first = fit(scene, start.a());
		scene.take(j);
		scene.put(i, first);
		final Chain second = fit(scene, start.b());
		scene.take(i);
		return new Exchanged(first, second, price(scene, j, first, second) - before);
	}

	private double price(final Scene scene, final int j, final Chain a, final Chain b) {
		final double one = scene.window(List.of(b)).price(b, weights.tracked()).energy();
		scene.put(j, b);
		final double other = scene.window(List.of(a)).price(a, weights.tracked()).energy();
		scene.take(j);
		return one + other;
	}

	private Chain fit(final Scene scene, final Chain start) {
		final Fit fit = scene.window(List.of(start)).fit(start, Optional.of(start),
			weights.tracked());
		return fit.chain();
	}

	/** The cheapest course through both possibilities. */
	private void decide(final List<Settled> filaments, final int i, final int j,
		final List<List<Exchanged>> others) {
		final Settled first = filaments.get(i), second = filaments.get(j);
		final List<double[]> prices = new ArrayList<>();
		for (final List<Exchanged> other : others)
			prices.add(DoubleStream
				.concat(DoubleStream.of(0), other.stream().mapToDouble(e -> e.more)).toArray());
		final double usualFirst = SceneSettler.usualMotion(first.chains());
		final double usualSecond = SceneSettler.usualMotion(second.chains());
		final TrellisPath path = Trellis.solve(prices,
			(t, v, u, w) -> SceneSettler
				.motion(chain(first, others, t, v, true).distance(chain(first, others, u, w, true))
					/ usualFirst)
				+ SceneSettler.motion(
					chain(second, others, t, v, false).distance(chain(second, others, u, w, false))
						/ usualSecond),
			progress);
		final List<Chain> a = new ArrayList<>(), b = new ArrayList<>();
		final double[] gapA = first.gap().clone(), gapB = second.gap().clone();
		for (int t = 0; t < others.size(); t++) {
			final int chosen = path.choice()[t];
			a.add(chain(first, others, t, chosen, true));
			b.add(chain(second, others, t, chosen, false));
			final double gap = path.gap(t, v -> v != chosen);
			gapA[t] = Math.min(gapA[t], gap);
			gapB[t] = Math.min(gapB[t], gap);
		}
		filaments.set(i, new Settled(a, gapA, first.lengthError()));
		filaments.set(j, new Settled(b, gapB, second.lengthError()));
	}

	private static Chain chain(final Settled filament, final List<List<Exchanged>> others,
		final int t, final int which, final boolean isFirst) {
		if (which == 0)
			return filament.chains().get(t);
		final Exchanged other = others.get(t).get(which - 1);
		return isFirst ? other.a : other.b;
	}
}
