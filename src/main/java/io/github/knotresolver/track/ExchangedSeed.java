package io.github.knotresolver.track;

import java.util.ArrayList;
import java.util.Collections;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;

import io.github.knotresolver.fit.Chain;
import io.github.knotresolver.fit.Scene;
import io.github.knotresolver.progress.Progress;
import io.github.knotresolver.progress.Workers;

/**
 * Two filaments that touch where a pass began may have been taken for each other's halves there,
 * each as long as it then is. They are explained as well as long as they cross, and by gliders
 * that go equally fast for as long as that; where they part, light is left around both of them. So
 * two that are both often unclear are followed from there with halves exchanged, beside all others.
 */
final class ExchangedSeed {

	private final SceneLine line;
	private final SceneWeights weights;
	private final Workers workers;
	private final Progress progress;

	ExchangedSeed(final SceneLine line, final SceneWeights weights, final Workers workers,
		final Progress progress) {
		this.line = line;
		this.weights = weights;
		this.workers = workers;
		this.progress = progress;
	}

	/** Two filaments by their numbers, and in how many frames both are unclear. */
	private record Pair(int i, int j, int unclear) {
	}

	/**
	 * The pass with halves exchanged where that leaves less of the movie's light; itself if that is
	 * nowhere so. O(frames) for every two that are tried, of which there are at most {@link
	 * SceneTuning#SEED_EXCHANGES}.
	 */
	PricedPass mended(final PricedPass pass) {
		PricedPass best = pass;
		for (final Pair pair : pairs(pass)) {
			progress.checkCancelled();
			final Optional<PricedPass> other = exchanged(best, pair);
			if (other.isPresent() && other.get().price() < best.price()
				- SceneTuning.SELDOM_UNCLEAR * SceneTuning.UNCLEAR_LIGHT)
				best = other.get();
		}
		return best;
	}

	/** Those that are both often unclear, the most often first. */
	private static List<Pair> pairs(final PricedPass pass) {
		final boolean[][] clear = pass.clear();
		final List<Chain> start = pass.pass().chains().get(pass.pass().start());
		final List<Pair> pairs = new ArrayList<>();
		for (int i = 0; i < clear.length; i++)
			for (int j = 0; j < i; j++) {
				int both = 0;
				for (int t = 0; t < clear[i].length; t++)
					both += clear[i][t] || clear[j][t] ? 0 : 1;
				if (both > SceneTuning.SELDOM_UNCLEAR * clear[i].length
					&& start.get(i).comesNear(start.get(j), SceneTuning.SWAP_TOUCH))
					pairs.add(new Pair(i, j, both));
			}
		pairs.sort(Comparator.comparingInt(Pair::unclear).reversed());
		return pairs.subList(0, Math.min(SceneTuning.SEED_EXCHANGES, pairs.size()));
	}

	/** Both followed again with halves exchanged where the pass began; empty if none fit there. */
	private Optional<PricedPass> exchanged(final PricedPass priced, final Pair pair) {
		final ScenePass pass = priced.pass();
		return start(pass, pair)
			.map(two -> PricedPass.of(followed(pass, pair, two), line, workers));
	}

	/** The cheapest exchange in the frame in which a pass began, as long as the light says. */
	private Optional<PairFit.Two> start(final ScenePass pass, final Pair pair) {
		final Scene scene = line.scene(pass.start(), pass.chains().get(pass.start()));
		final Chain a = scene.chain(pair.i), b = scene.chain(pair.j);
		scene.take(pair.i);
		scene.take(pair.j);
		final PairFit fit = new PairFit(scene, pair.i, pair.j, weights.free(),
			SceneTuning.SEED_SWEEPS);
		return TailSwap.ofAnyLength(a, b).stream().map(two -> fit.fitted(two.a(), two.b()))
			.min(Comparator.comparingDouble(PairFit.Two::price));
	}

	/** A pass with two that are followed from where it began, beside all others. */
	private ScenePass followed(final ScenePass pass, final Pair pair, final PairFit.Two two) {
		final int n = pass.chains().size(), start = pass.start();
		final List<List<Chain>> all = new ArrayList<>(Collections.nCopies(n, List.of()));
		all.set(start, with(pass.chains().get(start), pair, List.of(two.a(), two.b())));
		for (final int step : new int[]{1, -1}) {
			final SceneTracker tracker = new SceneTracker(line.tables(), weights, line.noise(),
				List.of(two.a(), two.b()));
			for (int t = start + step; t >= 0 && t < n; t += step) {
				progress.checkCancelled();
				final List<Chain> others = new ArrayList<>(pass.chains().get(t));
				others.remove(pair.i);
				others.remove(pair.j);
				all.set(t,
					with(pass.chains().get(t), pair, tracker.step(line.frames().get(t), others)));
			}
		}
		return new ScenePass(start, all);
	}

	private static List<Chain> with(final List<Chain> chains, final Pair pair,
		final List<Chain> two) {
		final List<Chain> all = new ArrayList<>(chains);
		all.set(pair.i, two.get(0));
		all.set(pair.j, two.get(1));
		return all;
	}
}
