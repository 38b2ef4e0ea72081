
package io.github.knotresolver.track;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;

import io.github.knotresolver.fit.Chain;
import io.github.knotresolver.fit.Scene;
import io.github.knotresolver.progress.Progress;

/**
 * All filaments followed from one frame through the whole movie.
 *
 * @param start index of the frame
 * @param chains for each frame its filaments, in the same order
 */
record ScenePass(int start, List<List<Chain>> chains) {

	/** Price of a filament, in strands squared. */
	private static final double PER_FILAMENT = 3;

	/** Follows the filaments of a seed forwards and backwards. */
	static ScenePass from(final int start, final List<Chain> seed, final SceneLine line,
		final SceneWeights weights, final Progress progress) {
		final int n = line.frames().size();
		final List<List<Chain>> all = new ArrayList<>(Collections.nCopies(n, List.of()));
		all.set(start, seed);
		for (final int direction : new int[]{1, -1}) {
			final SceneTracker tracker = new SceneTracker(line.tables(), weights,
				line.noise(), seed);
			for (int t = start + direction; t >= 0 && t < n; t += direction) {
				progress.checkCancelled();
				all.set(t, tracker.step(line.frames().get(t)));
			}
		}
		return new ScenePass(start, all);
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

	/** One filament in all frames. */
	List<Chain> filament(final int k) {
		return chains.stream().map(c -> c.get(k)).toList();
	}

	/**
	 * What the pass does not explain, per frame, and a price for every filament: of two
	 * passes the one with less is right, also about how many filaments there are.
	 */
	double price(final SceneLine line) {
		final double noise = line.noise();
		double sum = 0;
		for (int t = 0; t < chains.size(); t++) {
			final FrameView frame = line.frames().get(t);
			final Scene scene = new Scene(frame.light(), line.tables(), chains.get(t));
			sum += new Unexplained(scene, noise).within(scene.near(line.near(t)));
		}
		return sum / chains.size() + priceOfFilaments();
	}

	double priceOfFilaments() {
		return PER_FILAMENT * filaments();
	}

	int filaments() {
		return chains.get(start).size();
	}
}
