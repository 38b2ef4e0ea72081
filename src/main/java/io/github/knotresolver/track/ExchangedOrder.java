package io.github.knotresolver.track;

import java.util.Arrays;
import java.util.List;

import io.github.knotresolver.fit.Fit;
import io.github.knotresolver.image.LineAppearance;

/**
 * Frames in which a filament may run along the same lines in another order. Two strands that lie
 * beside each other between two places cross at both or only touch there; what differs is small,
 * but the same in all frames that follow each other, so that their sum says more than is known.
 * If many of these frames are by themselves cheaper in the other order, or most a little, the order is
 * a guess in all.
 */
final class ExchangedOrder {

	static final String WHY = "Doubtful: in this frame or one beside it the same lines in another order explain the light better.";

	private ExchangedOrder() {
	}

	/**
	 * Looks at a movie; O(fits * length²).
	 *
	 * @param path the fits that were chosen
	 * @param pools all fits of each frame
	 * @param sigma of the line in pixels
	 * @return for each frame whether the order of its contour is a guess
	 */
	static boolean[] guessed(final TrellisPath path, final List<List<Fit>> pools,
		final double sigma) {
		final double width = LineAppearance.FULL_WIDTH * sigma;
		final boolean[] guessed = new boolean[pools.size()];
		int from = 0;
		int clearly = 0;
		int cheaper = 0;
		for (int t = 0; t <= guessed.length; t++) {
			final double more = t == guessed.length
				? Double.POSITIVE_INFINITY
				: more(pools.get(t), path.choice()[t], width);
			if (more == Double.POSITIVE_INFINITY) {
				Arrays.fill(guessed, from, t,
					clearly > 0 && clearly >= TrackTuning.EXCHANGED_OFTEN * (t - from)
						|| cheaper > TrackTuning.EXCHANGED_MOSTLY * (t - from));
				from = t + 1;
				clearly = 0;
				cheaper = 0;
			} else {
				clearly += more < -TrackTuning.EXCHANGED_BETTER ? 1 : 0;
				cheaper += more < 0 ? 1 : 0;
			}
		}
		return guessed;
	}

	/** What another order costs more in a frame by itself; infinite if there is none. */
	private static double more(final List<Fit> pool, final int choice, final double width) {
		if (choice < 0)
			return Double.POSITIVE_INFINITY;
		final Fit chosen = pool.get(choice);
		return pool.stream()
			.filter(f -> FitConfidence.isExchanged(f.chain(), chosen.chain(), width))
			.mapToDouble(f -> f.energy() - chosen.energy()).min().orElse(Double.POSITIVE_INFINITY);
	}
}
