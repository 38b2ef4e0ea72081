
package io.github.knotresolver.track;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.stream.DoubleStream;
import java.util.stream.Stream;

import io.github.knotresolver.fit.Chain;
import io.github.knotresolver.fit.Scene;
import io.github.knotresolver.progress.Progress;
import io.github.knotresolver.progress.Workers;
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
	private final Workers workers;
	private final Progress progress;
	private final boolean thorough;

	TailExchanges(final SceneLine line, final SceneWeights weights, final Workers workers,
		final Progress progress) {
		this(line, weights, workers, progress, false);
	}

	/**
	 * @param thorough whether two are looked at however seldom they touch, and fitted to the end: it is
	 *          known that they were exchanged somewhere
	 */
	TailExchanges(final SceneLine line, final SceneWeights weights, final Workers workers,
		final Progress progress, final boolean thorough) {
		this.line = line;
		this.weights = weights;
		this.workers = workers;
		this.progress = progress;
		this.thorough = thorough;
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
				final List<Chain> before = checked.get(i).chains();
				check(checked, i, j);
				if (!checked.get(i).chains().equals(before))
					likeNeighbours(checked, i, j);
			}
		return checked;
	}

	/** All filaments, and what two of them cost: light, bending and motion. */
	record PricedPair(List<Settled> filaments, double price) {
	}

	/** Two filaments, with tails exchanged where that is cheaper. O(frames). */
	PricedPair course(final List<Settled> filaments, final int i, final int j) {
		final List<Settled> checked = new ArrayList<>(filaments);
		double price = check(checked, i, j);
		for (final PairFit.Two two : priced(filaments, i, j))
			price += two.price();
		return new PricedPair(checked, price);
	}

	/** The two in every frame, priced. */
	private List<PairFit.Two> priced(final List<Settled> filaments, final int i, final int j) {
		return workers.map(line.frames().size(), t -> {
			final Chain a = filaments.get(i).chains().get(t), b = filaments.get(j).chains().get(t);
			return new PairFit.Two(a, b, pair(filaments, i, j, t).price(a, b));
		});
	}

	/** The two in a frame, taken out. */
	PairFit pair(final List<Settled> filaments, final int i, final int j, final int t) {
		final Scene scene = line.scene(t, filaments.stream().map(s -> s.chains().get(t)).toList());
		scene.take(i);
		scene.take(j);
		return thorough
			? new PairFit(scene, i, j, weights.settled(), SceneTuning.HALVES_SWEEPS)
			: new PairFit(scene, i, j, weights.tracked(), 1);
	}

	/** Exchanges two where that is cheaper; what their motion costs and the exchanges gain. */
	private double check(final List<Settled> filaments, final int i, final int j) {
		final List<List<Exchanged>> others = workers.map(line.frames().size(),
			t -> exchanged(filaments, i, j, t));
		final long possible = others.stream().filter(o -> !o.isEmpty()).count();
		return possible >= SceneTuning.EXCHANGE_FEWEST || thorough
			? decide(filaments, i, j, others)
			: 0;
	}

	/** What two chains are with their tails exchanged, or their heads; nothing if they are far apart. */
	private static List<PairFit.Two> exchanges(final Chain a, final Chain b) {
		return a.start().distanceTo(b.start()) < a.length() + b.length()
			? TailSwap.everywhere(a, b, SceneTuning.EXCHANGE_LENGTH)
			: List.of();
	}

	/**
	 * The best exchanges in a frame, of the tails and of the heads: those that show, and those that
	 * are cheaper, as where the two lie side by side.
	 */
	private List<Exchanged> exchanged(final List<Settled> filaments, final int i, final int j,
		final int t) {
		final Chain a = filaments.get(i).chains().get(t), b = filaments.get(j).chains().get(t);
		final List<PairFit.Two> possible = exchanges(a, b);
		if (possible.isEmpty())
			return List.of();
		final PairFit pair = pair(filaments, i, j, t);
		final double before = pair.price(a, b);
		final List<PairFit.Two> tails = new ArrayList<>(), heads = new ArrayList<>();
		for (final PairFit.Two p : possible) {
			final double energy = pair.price(p.a(), p.b());
			final boolean keepsHeads = p.a().start().distanceTo(a.start()) < SceneTuning.END_STAYS
				&& p.b().start().distanceTo(b.start()) < SceneTuning.END_STAYS;
			if (energy < before + SceneTuning.EXCHANGE_HOPELESS)
				(keepsHeads ? tails : heads).add(new PairFit.Two(p.a(), p.b(), energy));
		}
		return Stream.of(tails, heads).flatMap(some -> cheapest(pair, some).stream())
			.map(f -> new Exchanged(f.a(), f.b(), f.price() - before))
			.filter(e -> e.more < -SceneTuning.TIP_BETTER || shows(e.a, a) && shows(e.b, b))
			.toList();
	}

	/** The most promising of some exchanges fitted, and the cheapest of those. */
	private static Optional<PairFit.Two> cheapest(final PairFit pair,
		final List<PairFit.Two> some) {
		return some.stream().sorted(Comparator.comparingDouble(PairFit.Two::price))
			.limit(SceneTuning.EXCHANGE_FITTED).map(p -> pair.fitted(p.a(), p.b()))
			.min(Comparator.comparingDouble(PairFit.Two::price));
	}

	static boolean shows(final Chain other, final Chain chain) {
		return other.farthest(chain) > SceneTuning.VISIBLY_FAR;
	}

	/**
	 * Two filaments in each frame as the one before or after it says, where that is cheaper. O(frames
	 * in which they are not there yet), there and back.
	 *
	 * @param filaments all of them; these two are replaced
	 */
	void likeNeighbours(final List<Settled> filaments, final int i, final int j) {
		final int n = line.frames().size();
		final Settled first = filaments.get(i), second = filaments.get(j);
		final List<PairFit.Two> before = priced(filaments, i, j);
		final List<PairFit.Two> two = new ArrayList<>(before);
		for (final int step : new int[]{1, -1})
			for (int t = step > 0 ? 2 : n - 3; t >= 0 && t < n; t += step) {
				progress.checkCancelled();
				final PairFit.Two here = two.get(t), last = two.get(t - step);
				final Chain a = onwards(two.get(t - 2 * step).a(), last.a());
				final Chain b = onwards(two.get(t - 2 * step).b(), last.b());
				if (Math.max(a.farthest(here.a()), b.farthest(here.b())) < SceneTuning.HALVES_OFF)
					continue;
				final PairFit.Two other = pair(filaments, i, j, t).fitted(a, b);
				if (other.price() < here.price())
					two.set(t, other);
			}
		filaments.set(i, with(first, two.stream().map(PairFit.Two::a).toList(), before, two));
		filaments.set(j, with(second, two.stream().map(PairFit.Two::b).toList(), before, two));
	}

	private static Chain onwards(final Chain before, final Chain now) {
		return now.slid(before.slide(now));
	}

	/** A filament with other chains, no surer than those are cheaper where they differ. */
	private static Settled with(final Settled filament, final List<Chain> chains,
		final List<PairFit.Two> before, final List<PairFit.Two> after) {
		final double[] gap = filament.gap().clone();
		for (int t = 0; t < gap.length; t++)
			if (shows(chains.get(t), filament.chains().get(t)))
				gap[t] = Math.min(gap[t], before.get(t).price() - after.get(t).price());
		return new Settled(chains, gap, filament.lengthError());
	}

	/** The cheapest course through both possibilities. */
	private double decide(final List<Settled> filaments, final int i, final int j,
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
			final int frame = t;
			final double gap = path.gap(t,
				v -> shows(chain(first, others, frame, v, true), a.get(frame))
					|| shows(chain(second, others, frame, v, false), b.get(frame)));
			gapA[t] = Math.min(gapA[t], gap);
			gapB[t] = Math.min(gapB[t], gap);
		}
		filaments.set(i, new Settled(a, gapA, first.lengthError()));
		filaments.set(j, new Settled(b, gapB, second.lengthError()));
		return path.total();
	}

	private static Chain chain(final Settled filament, final List<List<Exchanged>> others,
		final int t, final int which, final boolean isFirst) {
		if (which == 0)
			return filament.chains().get(t);
		final Exchanged other = others.get(t).get(which - 1);
		return isFirst ? other.a : other.b;
	}
}
