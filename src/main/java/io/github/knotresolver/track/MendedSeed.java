package io.github.knotresolver.track;

import java.util.ArrayList;
import java.util.Collections;
import java.util.Comparator;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.stream.IntStream;

import io.github.knotresolver.fit.Chain;
import io.github.knotresolver.fit.Scene;
import io.github.knotresolver.progress.Progress;
import io.github.knotresolver.progress.Workers;
import io.github.knotresolver.track.SeedPieces.Other;

/**
 * A frame does not tell whether two filaments lie end to end or one lies there, nor which halves
 * belong together where two cross at a small angle; those before and after it do, since what is
 * wrongly taken for one cannot be followed. So a seed is followed for a while both ways in time.
 * Filaments around which light is left there are cut, or exchange what is behind a place where they
 * touch others; what can be followed better is kept.
 */
final class MendedSeed {

	private final SceneLine line;
	private final SceneWeights weights;
	private final Workers workers;
	private final Progress progress;
	private final int start;
	private final int first;
	private final int end;
	private final SeedPieces pieces;

	/** @param start the frame of the seed */
	MendedSeed(final SceneLine line, final SceneWeights weights, final Workers workers,
		final Progress progress, final int start) {
		this.line = line;
		this.weights = weights;
		this.workers = workers;
		this.progress = progress;
		this.start = start;
		final int n = line.frames().size(),
			reach = Math.max(SceneTuning.MEND_LEAST, n / SceneTuning.MEND_PART);
		first = Math.max(0, start - reach);
		end = Math.min(n, start + reach + 1);
		pieces = new SeedPieces(line, weights, start);
	}

	/** The filaments of a seed, those mended that can be followed better then, in all frames. */
	ScenePass followed(final List<Chain> seed) {
		final ScenePass course = nearby(seed);
		final ScenePass mended = mended(course);
		return mended == course
			? onwards(course)
			: ScenePass.from(start, mended.chains().get(start - first), line, weights, workers,
				progress);
	}

	private ScenePass mended(final ScenePass course) {
		PricedPass now = priced(course);
		final Set<List<Chain>> tried = new HashSet<>();
		for (int round = 0; round < SceneTuning.MEND_ROUNDS; round++) {
			final PricedPass before = now;
			final List<Other> others = others(now, tried);
			others.forEach(o -> tried.add(of(before.pass().chains().get(start - first), o.of())));
			final List<Other> better = better(before, others);
			now = better(before, better, better.size());
			if (now == before)
				now = better(before, better, 1);
			if (now == before)
				break;
		}
		return now.pass();
	}

	/** Those that can be followed better, the best first; of each filament one. */
	private List<Other> better(final PricedPass now, final List<Other> others) {
		final List<Double> more = workers.map("Looking for filaments", progress, others.size(),
			i -> more(now.pass(), others.get(i)));
		final List<Other> better = new ArrayList<>();
		IntStream.range(0, others.size()).boxed()
			.filter(i -> more.get(i) < -SceneTuning.MEND_BETTER)
			.sorted(Comparator.comparingDouble(more::get)).map(others::get)
			.filter(o -> better.stream().allMatch(b -> Collections.disjoint(b.of(), o.of())))
			.forEach(better::add);
		return better;
	}

	/** With the best of some others, if that leaves less light. */
	private PricedPass better(final PricedPass now, final List<Other> others, final int most) {
		if (others.isEmpty())
			return now;
		final PricedPass with = priced(
			with(now.pass(), others.subList(0, Math.min(most, others.size()))));
		return with.price() < now.price() ? with : now;
	}

	/**
	 * What others cost more when they are followed, mean over the frames; infinite if that is soon
	 * seen to be too much.
	 */
	private double more(final ScenePass course, final Other other) {
		final List<Chain> then = course.chains().get(start - first);
		double more = more(start, SeedPieces.without(then, other.of()), of(then, other.of()),
			other.instead());
		for (final int step : new int[]{1, -1}) {
			final SceneTracker tracker = new SceneTracker(line.tables(), weights, line.noise(),
				other.instead());
			for (int t = start + step; t >= first && t < end; t += step) {
				progress.checkCancelled();
				final List<Chain> here = course.chains().get(t - first);
				final List<Chain> beside = SeedPieces.without(here, other.of());
				more += more(t, beside, of(here, other.of()),
					tracker.step(line.frames().get(t), beside));
				if (more > SceneTuning.MEND_HOPELESS)
					return Double.POSITIVE_INFINITY;
			}
		}
		return more / (end - first)
			+ SceneTuning.PER_FILAMENT * (other.instead().size() - other.of().size());
	}

	/** What some chains cost more than others in a frame, beside all that stays. */
	private double more(final int t, final List<Chain> beside, final List<Chain> before,
		final List<Chain> after) {
		final Scene scene = line.scene(t, beside);
		return energy(scene, after) - energy(scene, before);
	}

	private double energy(final Scene scene, final List<Chain> chains) {
		final int all = scene.size();
		double energy = 0;
		for (final Chain chain : chains) {
			energy += scene.window(List.of(chain)).price(chain, weights.tracked()).energy();
			scene.add(chain);
		}
		for (int k = all; k < scene.size(); k++)
			scene.take(k);
		return energy;
	}

	/** A course on to both ends of the movie. */
	private ScenePass onwards(final ScenePass course) {
		final List<List<Chain>> near = course.chains();
		final int last = near.size() - 1;
		final List<List<List<Chain>>> ways = workers.map(2,
			way -> way == 0
				? ScenePass.followed(tracker(near.get(Math.max(0, last - 1)), near.get(last)), end,
					line.frames().size(), line, progress)
				: ScenePass.followed(tracker(near.get(Math.min(1, last)), near.get(0)), first - 1,
					-1, line, progress));
		return new ScenePass(start, ScenePass.joined(ways.get(1), near, ways.get(0)));
	}

	private SceneTracker tracker(final List<Chain> before, final List<Chain> now) {
		return new SceneTracker(line.tables(), weights, line.noise(), before, now);
	}

	private ScenePass nearby(final List<Chain> seed) {
		final List<List<List<Chain>>> ways = workers.map(2,
			way -> followed(seed, 1 - 2 * way, Collections.nCopies(end - first, List.of())));
		return course(ways.get(1), seed, ways.get(0));
	}

	private ScenePass course(final List<List<Chain>> before, final List<Chain> seed,
		final List<List<Chain>> after) {
		return new ScenePass(start - first, ScenePass.joined(before, List.of(seed), after));
	}

	private List<List<Chain>> followed(final List<Chain> seed, final int step,
		final List<List<Chain>> beside) {
		final SceneTracker tracker = new SceneTracker(line.tables(), weights, line.noise(), seed);
		final List<List<Chain>> all = new ArrayList<>();
		for (int t = start + step; t >= first && t < end; t += step) {
			progress.checkCancelled();
			all.add(tracker.step(line.frames().get(t), beside.get(t - first)));
		}
		return all;
	}

	/** A course with other filaments instead of some, all others as they are. */
	private ScenePass with(final ScenePass course, final List<Other> others) {
		final List<Integer> out = others.stream().flatMap(o -> o.of().stream()).toList();
		final List<Chain> in = others.stream().flatMap(o -> o.instead().stream()).toList();
		final List<List<Chain>> beside = course.chains().stream()
			.map(c -> SeedPieces.without(c, out)).toList();
		final ScenePass two = course(followed(in, -1, beside), in, followed(in, 1, beside));
		final List<List<Chain>> all = new ArrayList<>();
		for (int i = 0; i < beside.size(); i++) {
			final List<Chain> here = new ArrayList<>(beside.get(i));
			here.addAll(two.chains().get(i));
			all.add(here);
		}
		return new ScenePass(start - first, all);
	}

	private static List<Chain> of(final List<Chain> chains, final List<Integer> which) {
		return which.stream().map(chains::get).toList();
	}

	private PricedPass priced(final ScenePass course) {
		return PricedPass.of(course, first, line, workers);
	}

	/**
	 * What those might be around which light is left, and what was not tried yet; nothing if that is
	 * so around every one of many.
	 */
	private List<Other> others(final PricedPass now, final Set<List<Chain>> tried) {
		final List<Chain> seed = now.pass().chains().get(start - first);
		final boolean[] lost = lost(now);
		if (seed.size() > SceneTuning.MEND_HANDFUL && areAll(lost))
			return List.of();
		final List<List<Other>> all = workers.map(seed.size(), i -> {
			final List<Other> of = new ArrayList<>();
			if (!lost[i])
				return of;
			if (!tried.contains(List.of(seed.get(i))))
				of.addAll(pieces.cuts(seed, i, first, now.pass().filament(i)));
			for (int j = 0; j < seed.size(); j++)
				if (j != i && !(j < i && lost[j])
					&& seed.get(i).comesNear(seed.get(j), SceneTuning.SWAP_TOUCH)
					&& !tried.contains(List.of(seed.get(i), seed.get(j))))
					of.addAll(pieces.exchanges(seed, i, j));
			return of;
		});
		return all.stream().flatMap(List::stream).toList();
	}

	private static boolean areAll(final boolean[] lost) {
		return IntStream.range(0, lost.length).allMatch(k -> lost[k]);
	}

	/** For each filament whether light is left around it more than seldom. */
	private boolean[] lost(final PricedPass course) {
		final boolean[] lost = new boolean[course.clear().length];
		for (int k = 0; k < lost.length; k++) {
			int unclear = 0;
			for (final boolean clear : course.clear()[k])
				unclear += clear ? 0 : 1;
			lost[k] = unclear > SceneTuning.SELDOM_UNCLEAR * (end - first);
		}
		return lost;
	}
}
