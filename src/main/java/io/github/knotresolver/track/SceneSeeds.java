
package io.github.knotresolver.track;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.SortedSet;
import java.util.TreeSet;

import io.github.knotresolver.fit.Chain;
import io.github.knotresolver.progress.Progress;
import io.github.knotresolver.progress.Workers;

/** The frames from which the filaments of a movie are followed. */
final class SceneSeeds {

	/** About so many frames are looked at, each with its two neighbours. */
	private static final int LOOKS = 12;

	private static final int SPACING = 5;

	/** A seed that is worth less than this share of the best is none. */
	private static final double WORTH = 0.7;

	private final SceneLine line;
	private final SceneWeights weights;

	SceneSeeds(final SceneLine line, final SceneWeights weights) {
		this.line = line;
		this.weights = weights;
	}

	/** All seeds, the best first. */
	List<SceneSeed> all(final Workers workers, final Progress progress) {
		final int n = line.frames().size();
		final int stride = Math.max(3, n / LOOKS);
		final List<Integer> middles = new ArrayList<>();
		for (int t = Math.min(1, n - 1); t < Math.max(1, n - 1); t += stride)
			middles.add(t);
		if (middles.isEmpty())
			middles.add(0);
		final SortedSet<Integer> needed = new TreeSet<>();
		for (final int t : middles)
			for (int u = Math.max(0, t - 1); u <= Math.min(n - 1, t + 1); u++)
				needed.add(u);
		final List<Integer> frames = List.copyOf(needed);
		final SceneSeeder seeder = new SceneSeeder(line.tables(), weights);
		final List<List<Chain>> chains = workers.map("Looking for filaments", progress,
			frames.size(), i -> seeder.chains(line.frames().get(frames.get(i))));
		final List<SceneSeed> seeds = new ArrayList<>();
		for (final int t : middles) {
			final List<List<Chain>> beside = new ArrayList<>();
			for (int u = Math.max(0, t - 1); u <= Math.min(n - 1, t + 1); u++)
				if (u != t)
					beside.add(chains.get(frames.indexOf(u)));
			seeds
				.add(SceneSeed.of(t, chains.get(frames.indexOf(t)), beside, line.lengthOfLight(t)));
		}
		seeds.sort(Comparator.comparingDouble(SceneSeed::worth).reversed()
			.thenComparingInt(SceneSeed::frame));
		return seeds;
	}

	/** A few good seeds, well apart in time or with other numbers of filaments. */
	static List<SceneSeed> chosen(final List<SceneSeed> all, final int most, final int frames) {
		final List<SceneSeed> chosen = new ArrayList<>();
		for (final SceneSeed seed : all) {
			if (chosen.size() == most
				|| !chosen.isEmpty() && seed.worth() < WORTH * chosen.get(0).worth())
				break;
			if (chosen.stream().allMatch(c -> Math.abs(c.frame() - seed.frame()) > frames / SPACING)
				|| chosen.stream().allMatch(c -> c.chains().size() != seed.chains().size()))
				chosen.add(seed);
		}
		return chosen;
	}
}
