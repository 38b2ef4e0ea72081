
package io.github.knotresolver.track;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;

import io.github.knotresolver.fit.Chain;
import io.github.knotresolver.geometry.RobustStatistics;
import io.github.knotresolver.progress.Progress;
import io.github.knotresolver.progress.Workers;
import io.github.knotresolver.track.PairFit.Two;
import io.github.knotresolver.track.SceneLengths.Length;
import io.github.knotresolver.track.SceneLengths.LengthStep;
import io.github.knotresolver.track.SceneSettler.Settled;
import io.github.knotresolver.track.TailExchanges.PricedPair;

/**
 * Two filaments one of which gets shorter by what the other gets longer are each other's halves
 * before some frame, or after it; two that cross at a small angle may be that all the time. With the
 * lengths of either time, or of either halves, their tails are exchanged where that is cheaper; that
 * course is right which is cheapest over the whole movie.
 */
final class ExchangedHalves {

	private final SceneLine line;
	private final SceneLengths measure;
	private final TailExchanges exchanges;
	private final Workers workers;
	private final Progress progress;

	ExchangedHalves(final SceneLine line, final SceneWeights weights, final Workers workers,
		final Progress progress) {
		this.line = line;
		measure = new SceneLengths(line, weights);
		exchanges = new TailExchanges(line, weights, workers, progress, true);
		this.workers = workers;
		this.progress = progress;
	}

	/**
	 * The filaments with those mended that are, or may be, each other's halves. O(frames) for every
	 * two.
	 *
	 * @param lengths of all filaments
	 * @return empty if there are no such two
	 */
	Optional<List<Settled>> mended(final List<Settled> filaments, final List<Length> lengths) {
		List<Settled> mended = filaments;
		for (int i = 0; i < lengths.size(); i++)
			for (int j = 0; j < i; j++) {
				final List<double[]> others = balance(lengths.get(i), lengths.get(j))
					? ofEitherTime(lengths.get(i), lengths.get(j))
					: exchangedLengths(mended, i, j).stream().toList();
				if (!others.isEmpty())
					mended = mended(mended, i, j, others);
			}
		return mended == filaments ? Optional.empty() : Optional.of(mended);
	}

	private static boolean balance(final Length a, final Length b) {
		return a.step().isPresent() && b.step().filter(a.step().get()::balances).isPresent();
	}

	private static List<double[]> ofEitherTime(final Length first, final Length second) {
		final LengthStep a = first.step().orElseThrow(), b = second.step().orElseThrow();
		return List.of(new double[]{a.before(), b.before()}, new double[]{a.after(), b.after()});
	}

	/**
	 * How long two would be as each other's halves, if that explains several frames better and they
	 * are equally long in all of them: gliders that cross at a small angle and are equally fast.
	 */
	private Optional<double[]> exchangedLengths(final List<Settled> filaments, final int i,
		final int j) {
		progress.checkCancelled();
		final int[] looks = SceneLengths.looks(line.frames().size());
		final List<Two> found = workers.map(looks.length, k -> halves(filaments, i, j, looks[k]))
			.stream().flatMap(Optional::stream).toList();
		if (found.size() < SceneTuning.LENGTH_FEWEST)
			return Optional.empty();
		final double[] a = found.stream().mapToDouble(two -> two.a().length()).toArray();
		final double[] b = found.stream().mapToDouble(two -> two.b().length()).toArray();
		if (Math.max(SceneLengths.scatter(a), SceneLengths.scatter(b)) > SceneTuning.LENGTH_STEP)
			return Optional.empty();
		return Optional.of(new double[]{RobustStatistics.median(a), RobustStatistics.median(b)});
	}

	/** Two in a frame as each other's halves, if that is something else and explains it better. */
	private Optional<Two> halves(final List<Settled> filaments, final int i, final int j,
		final int t) {
		final Chain a = filaments.get(i).chains().get(t), b = filaments.get(j).chains().get(t);
		if (!a.comesNear(b, SceneTuning.SWAP_TOUCH))
			return Optional.empty();
		final PairFit pair = exchanges.pair(filaments, i, j, t);
		final double now = pair.price(a, b);
		return TailSwap.ofAnyLength(a, b).stream()
			.filter(two -> differs(two.a(), a) && differs(two.a(), b))
			.map(two -> new Two(two.a(), two.b(), pair.price(two.a(), two.b())))
			.min(Comparator.comparingDouble(Two::price))
			.filter(two -> two.price() < now + SceneTuning.EXCHANGE_HOPELESS).map(pair::swept)
			.filter(two -> pair.price(two.a(), two.b()) < now);
	}

	private static boolean differs(final Chain other, final Chain chain) {
		return TailExchanges.shows(Chain.along(other.polyline(), chain.links(), other.length()),
			chain);
	}

	private List<Settled> mended(final List<Settled> filaments, final int i, final int j,
		final List<double[]> lengths) {
		final List<PricedPair> courses = new ArrayList<>();
		courses.add(exchanges.course(filaments, i, j));
		lengths.forEach(l -> courses.add(withLengths(filaments, i, j, l)));
		courses.sort(Comparator.comparingDouble(PricedPair::price));
		final List<Settled> best = new ArrayList<>(courses.get(0).filaments());
		for (final int k : new int[]{i, j})
			best.set(k, lessSure(courses, k));
		return best;
	}

	/** A filament of the cheapest course, less sure where others differ that are not much dearer. */
	private static Settled lessSure(final List<PricedPair> courses, final int k) {
		final Settled best = courses.get(0).filaments().get(k);
		final double[] gap = best.gap().clone();
		for (final PricedPair other : courses)
			for (int t = 0; t < gap.length; t++)
				if (other.filaments().get(k).chains().get(t)
					.farthest(best.chains().get(t)) > SceneTuning.VISIBLY_FAR)
					gap[t] = Math.min(gap[t], other.price() - courses.get(0).price());
		return new Settled(best.chains(), gap, best.lengthError());
	}

	/** The course of two filaments that begins with some lengths. */
	private PricedPair withLengths(final List<Settled> filaments, final int i, final int j,
		final double[] lengths) {
		List<Settled> now = as(filaments, i, j, lengths);
		for (int round = 0; round < SceneTuning.HALVES_ROUNDS; round++) {
			progress.checkCancelled();
			now = exchanges.course(now, i, j).filaments();
			exchanges.likeNeighbours(now, i, j);
			final ScenePass pass = ScenePass.of(now);
			final List<Length> found = measure.of(pass, List.of(i, j), pass.clear(line, workers),
				workers);
			now = as(now, i, j, found.stream().mapToDouble(Length::length).toArray());
		}
		return exchanges.course(now, i, j);
	}

	/** Two filaments as long as that in all frames. */
	private List<Settled> as(final List<Settled> filaments, final int i, final int j,
		final double[] lengths) {
		return with(filaments, i, j,
			workers.map(line.frames().size(),
				t -> exchanges.pair(filaments, i, j, t).fitted(
					as(filaments.get(i).chains().get(t), lengths[0]),
					as(filaments.get(j).chains().get(t), lengths[1]))));
	}

	private static Chain as(final Chain chain, final double length) {
		return Chain.along(chain.polyline(), chain.links(), length);
	}

	private static List<Settled> with(final List<Settled> filaments, final int i, final int j,
		final List<Two> two) {
		final List<Settled> all = new ArrayList<>(filaments);
		all.set(i, new Settled(two.stream().map(Two::a).toList(), filaments.get(i).gap(),
			filaments.get(i).lengthError()));
		all.set(j, new Settled(two.stream().map(Two::b).toList(), filaments.get(j).gap(),
			filaments.get(j).lengthError()));
		return all;
	}
}
