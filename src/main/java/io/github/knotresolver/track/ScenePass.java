
package io.github.knotresolver.track;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;

import io.github.knotresolver.fit.Chain;
import io.github.knotresolver.fit.Scene;
import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.geometry.RobustStatistics;
import io.github.knotresolver.progress.Progress;
import io.github.knotresolver.progress.Workers;

/**
 * All filaments followed from one frame through the whole movie.
 *
 * @param start index of the frame
 * @param chains for each frame its filaments, in the same order
 */
record ScenePass(int start, List<List<Chain>> chains) {

	/** Follows the filaments of a seed forwards and backwards, both at the same time. */
	static ScenePass from(final int start, final List<Chain> seed, final SceneLine line,
		final SceneWeights weights, final Workers workers, final Progress progress) {
		final List<List<List<Chain>>> ways = workers.map(2, way -> {
			final SceneTracker tracker = new SceneTracker(line.tables(), weights, line.noise(),
				seed);
			return way == 0
				? followed(tracker, start + 1, line.frames().size(), line, progress)
				: followed(tracker, start - 1, -1, line, progress);
		});
		return new ScenePass(start, joined(ways.get(1), List.of(seed), ways.get(0)));
	}

	/** The filaments from a frame on, forwards or backwards until one that is not followed any more. */
	static List<List<Chain>> followed(final SceneTracker tracker, final int from, final int until,
		final SceneLine line, final Progress progress) {
		final List<List<Chain>> all = new ArrayList<>();
		for (int t = from; t != until; t += until > from ? 1 : -1) {
			progress.checkCancelled();
			all.add(tracker.step(line.frames().get(t)));
		}
		return all;
	}

	/**
	 * The filaments in all frames.
	 *
	 * @param before in those before some, from the last to the first
	 * @param some in these
	 * @param after in those after them
	 */
	static List<List<Chain>> joined(final List<List<Chain>> before, final List<List<Chain>> some,
		final List<List<Chain>> after) {
		final List<List<Chain>> all = new ArrayList<>(before);
		Collections.reverse(all);
		all.addAll(some);
		all.addAll(after);
		return all;
	}

	/** The settled filaments as one pass. */
	static ScenePass of(final List<SceneSettler.Settled> settled) {
		final List<List<Chain>> chains = new ArrayList<>();
		for (int t = 0; t < settled.get(0).chains().size(); t++) {
			final int frame = t;
			chains.add(settled.stream().map(s -> s.chains().get(frame)).toList());
		}
		return new ScenePass(0, chains);
	}

	/**
	 * The same with one filament as it is known better; those that touch it are fitted again.
	 *
	 * @param k the filament
	 * @param known its chains in all frames
	 */
	ScenePass with(final int k, final List<Chain> known, final SceneLine line,
		final SceneWeights weights, final Workers workers) {
		return new ScenePass(start, workers.map(chains.size(), t -> {
			final List<Chain> here = new ArrayList<>(chains.get(t));
			here.set(k, known.get(t));
			final Scene scene = line.scene(t, here);
			for (int sweep = 0; sweep < 2; sweep++)
				for (int other = 0; other < scene.size(); other++)
					if (other != k && scene.mayTouch(k, other))
						refit(scene, other, weights);
			return scene.chains();
		}));
	}

	private static void refit(final Scene scene, final int k, final SceneWeights weights) {
		final Chain before = scene.chain(k);
		scene.take(k);
		scene.put(k,
			scene.window(List.of(before)).fit(before, Optional.empty(), weights.tracked()).chain());
	}

	/** How far a filament usually moves from frame to frame, in pixels. */
	double motion(final int k) {
		final double[] motion = new double[Math.max(0, chains.size() - 1)];
		for (int t = 0; t < motion.length; t++)
			motion[t] = chains.get(t).get(k).distance(chains.get(t + 1).get(k));
		return RobustStatistics.upperMedian(motion, 0);
	}

	/** For each filament and frame whether the light around it is explained. */
	boolean[][] clear(final SceneLine line, final Workers workers) {
		final boolean[][] clear = new boolean[filaments()][chains.size()];
		workers.map(chains.size(), t -> {
			final Unexplained left = new Unexplained(line.scene(t, chains.get(t)), line.noise());
			for (int k = 0; k < clear.length; k++)
				clear[k][t] = left.isClear(chains.get(t).get(k));
			return t;
		});
		return clear;
	}

	/** First and last plus one of the longest run of set frames. */
	static int[] longestRun(final boolean[] set) {
		int[] best = {0, 0};
		int from = 0;
		for (int t = 0; t <= set.length; t++)
			if (t == set.length || !set[t]) {
				if (t - from > best[1] - best[0])
					best = new int[]{from, t};
				from = t + 1;
			}
		return best;
	}

	/** Whether no light of another filament falls on one in a frame. */
	boolean isAlone(final int k, final int t, final SceneLine line) {
		final Scene scene = line.scene(t, chains.get(t));
		for (int other = 0; other < scene.size(); other++)
			if (other != k && scene.mayTouch(k, other))
				return false;
		return true;
	}

	/** A filament and those that touch it, or one that does, in nearly all frames; rising. */
	List<Integer> touching(final int k) {
		final List<Integer> group = new ArrayList<>(List.of(k));
		for (int next = 0; next < group.size(); next++)
			for (int j = 0; j < filaments(); j++)
				if (!group.contains(j) && touch(group.get(next), j))
					group.add(j);
		return group.stream().sorted().toList();
	}

	private boolean touch(final int i, final int j) {
		return chains.stream().filter(c -> c.get(i).comesNear(c.get(j), SceneTuning.TOUCH))
			.count() >= SceneTuning.PIECES_MOST * chains.size();
	}

	/** The filament one of whose ends is usually nearest to a place; -1 if none is near. */
	int endingAt(final Point place) {
		double nearest = SceneTuning.PLACE_NEAR;
		int which = -1;
		for (int k = 0; k < filaments(); k++) {
			final double distance = RobustStatistics.upperMedian(
				filament(k).stream()
					.mapToDouble(c -> Math.min(c.start().distanceTo(place),
						c.polyline().last().distanceTo(place)))
					.toArray(),
				Double.POSITIVE_INFINITY);
			if (distance < nearest) {
				nearest = distance;
				which = k;
			}
		}
		return which;
	}

	/** One filament in all frames. */
	List<Chain> filament(final int k) {
		return chains.stream().map(c -> c.get(k)).toList();
	}

	/**
	 * What the pass does not explain, per frame, and a price for every filament: of two
	 * passes the one with less is right, also about how many filaments there are.
	 */
	double price(final SceneLine line, final Workers workers) {
		return workers.map(chains.size(), t -> line.left(t, chains.get(t))).stream()
			.mapToDouble(Double::doubleValue).average().orElse(0) + priceOfFilaments();
	}

	double priceOfFilaments() {
		return SceneTuning.PER_FILAMENT * filaments();
	}

	int filaments() {
		return chains.get(start).size();
	}
}
