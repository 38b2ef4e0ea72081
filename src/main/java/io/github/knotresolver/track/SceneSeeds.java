
package io.github.knotresolver.track;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.SortedSet;
import java.util.TreeSet;

import io.github.knotresolver.fit.Chain;
import io.github.knotresolver.progress.Progress;
import io.github.knotresolver.progress.Workers;

/** The frames from which the filaments of a movie are followed. */
final class SceneSeeds {

	private final SceneLine line;
	private final SceneWeights weights;

	SceneSeeds(final SceneLine line, final SceneWeights weights) {
		this.line = line;
		this.weights = weights;
	}

	/** All seeds, the best first. */
	List<SceneSeed> all(final Workers workers, final Progress progress) {
		final int n = line.frames().size();
		final int stride = Math.max(3, n / SceneTuning.SEED_LOOKS);
		final List<Integer> middles = new ArrayList<>();
		for (int t = Math.min(1, n - 1); t < Math.max(1, n - 1); t += stride)
			middles.add(t);
		if (middles.isEmpty())
			middles.add(0);
		return at(middles, new ScenePool(line), workers, progress);
	}

	/**
	 * Seeds in some frames, the best first.
	 *
	 * @param middles the frames
	 * @param pool filaments that are known already
	 */
	List<SceneSeed> at(final List<Integer> middles, final ScenePool pool, final Workers workers,
		final Progress progress) {
		final int n = line.frames().size();
		final SortedSet<Integer> needed = new TreeSet<>();
		for (final int t : middles)
			for (int u = Math.max(0, t - 1); u <= Math.min(n - 1, t + 1); u++)
				needed.add(u);
		final List<Integer> frames = List.copyOf(needed);
		final SceneSeeder seeder = new SceneSeeder(line.tables(), weights);
		final List<List<Chain>> chains = workers.map("Looking for filaments", progress,
			frames.size(),
			i -> seeder.chains(line.frames().get(frames.get(i)), pool.known(frames.get(i))));
		final List<SceneSeed> seeds = new ArrayList<>();
		for (final int t : middles) {
			final List<List<Chain>> beside = new ArrayList<>();
			for (int u = Math.max(0, t - 1); u <= Math.min(n - 1, t + 1); u++)
				if (u != t)
					beside.add(chains.get(frames.indexOf(u)));
			seeds.add(SceneSeed.of(t, chains.get(frames.indexOf(t)), pool.known(t).size(), beside,
				line.lengthOfLight(t)));
		}
		seeds.sort(Comparator.comparingDouble(SceneSeed::worth).reversed()
			.thenComparingInt(SceneSeed::frame));
		return seeds;
	}

	/**
	 * Where to start from next: once, one of fewer filaments, which explain as much if the first
	 * one has taken pieces for filaments; then a good seed well apart in time, or with another number of
	 * filaments, from those that were used; if filaments are known already and no such seed is
	 * sound by itself, the best of the frames in which most of the light is theirs.
	 *
	 * @param first the seeds of the movie, the best first
	 * @param used from which it was started already, at least one
	 * @param pool filaments that are known
	 * @return empty if no other seed is worth a try
	 */
	Optional<SceneSeed> next(final List<SceneSeed> first, final List<SceneSeed> used,
		final ScenePool pool, final Workers workers, final Progress progress) {
		final double best = first.get(0).worth();
		if (used.size() == 1 && used.get(0).worth() >= SceneTuning.SEED_SOUND) {
			final int pieces = used.get(0).chains().size();
			final Optional<SceneSeed> fewer = first.stream()
				.filter(
					s -> s.chains().size() < pieces && s.worth() >= SceneTuning.SEED_FEWER * best)
				.findFirst();
			if (fewer.isPresent())
				return fewer;
		}
		final double enough = pool.isEmpty()
			? SceneTuning.SEED_WORTH * best
			: Math.max(SceneTuning.SEED_SOUND, SceneTuning.SEED_WORTH * best);
		final Optional<SceneSeed> another = first.stream().filter(s -> s.worth() >= enough)
			.filter(s -> isAnother(s, used)).findFirst();
		if (pool.isEmpty() || another.isPresent())
			return another;
		final Map<Integer, Double> covered = new LinkedHashMap<>();
		for (final SceneSeed seed : first)
			if (used.stream().noneMatch(u -> u.frame() == seed.frame())) {
				final double share = pool.coverage(seed.frame());
				if (share < SceneTuning.SEED_ALL)
					covered.put(seed.frame(), share);
			}
		final boolean anyApart = covered.keySet().stream().anyMatch(t -> isApart(t, used));
		final List<Integer> frames = covered.entrySet().stream()
			.filter(e -> !anyApart || isApart(e.getKey(), used))
			.sorted(Map.Entry.<Integer, Double>comparingByValue().reversed())
			.limit(SceneTuning.SEED_AGAIN).map(Map.Entry::getKey).toList();
		return at(frames, pool, workers, progress).stream().findFirst();
	}

	private boolean isAnother(final SceneSeed seed, final List<SceneSeed> used) {
		return isApart(seed.frame(), used)
			|| used.stream().allMatch(u -> u.chains().size() != seed.chains().size());
	}

	private boolean isApart(final int t, final List<SceneSeed> used) {
		return used.stream().allMatch(
			u -> Math.abs(u.frame() - t) > line.frames().size() / SceneTuning.SEED_SPACING);
	}
}
