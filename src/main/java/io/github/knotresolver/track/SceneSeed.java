
package io.github.knotresolver.track;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

import io.github.knotresolver.fit.Chain;
import io.github.knotresolver.geometry.Polyline;

/**
 * The filaments of one frame, as far as the frames beside it have them, too.
 *
 * @param frame index of the frame
 * @param chains its filaments; lengths are the medians of those frames
 * @param stable for each whether both other frames have it
 * @param coverage light in stable chains as a share of all light
 */
record SceneSeed(int frame, List<Chain> chains, boolean[] stable, double coverage) {

	/**
	 * @param frame index of the frame
	 * @param here its chains
	 * @param known so many of the first are known, with their lengths
	 * @param beside those of the frames beside it
	 * @param light of the whole frame, as the length of filament that shines so
	 */
	static SceneSeed of(final int frame, final List<Chain> here, final int known,
		final List<List<Chain>> beside, final double light) {
		final List<Chain> chains = new ArrayList<>();
		final boolean[] stable = new boolean[here.size()];
		double covered = 0;
		for (int k = 0; k < stable.length; k++) {
			final Chain chain = here.get(k);
			if (k < known) {
				chains.add(chain);
				stable[k] = true;
				covered += chain.length();
				continue;
			}
			final double[] lengths = new double[beside.size() + 1];
			lengths[0] = chain.length();
			int seen = 1;
			for (final List<Chain> other : beside) {
				final double length = lengthOfNearest(chain, other);
				if (length > 0)
					lengths[seen++] = length;
			}
			stable[k] = seen == lengths.length;
			Arrays.sort(lengths, 0, seen);
			final double length = seen % 2 == 1
				? lengths[seen / 2]
				: 0.5 * (lengths[seen / 2] + lengths[seen / 2 - 1]);
			chains.add(Chain.inScene(chain.polyline(), length));
			if (stable[k])
				covered += length;
		}
		return new SceneSeed(frame, chains, stable, covered / Math.max(1, light));
	}

	/** The length of the chain that lies where a chain is and is about as long; 0 if none is. */
	private static double lengthOfNearest(final Chain chain, final List<Chain> others) {
		double nearest = SceneTuning.SEED_NEAR, length = 0;
		for (final Chain other : others)
			if (Math.abs(other.length() - chain.length()) < Math.max(SceneTuning.SEED_LENGTH,
				SceneTuning.SEED_LENGTH_SHARE * chain.length())) {
				final double distance = distance(chain.polyline(), other.polyline());
				if (distance < nearest) {
					nearest = distance;
					length = other.length();
				}
			}
		return length;
	}

	/** Mean distance of points at equal shares of the length, in the better direction. */
	static double distance(final Polyline a, final Polyline b) {
		return Math.min(oneWay(a, b), oneWay(a, b.reversed()));
	}

	static double oneWay(final Polyline a, final Polyline b) {
		final Polyline p = a.divided(SceneTuning.SEED_POINTS),
			q = b.divided(SceneTuning.SEED_POINTS);
		double sum = 0;
		for (int i = 0; i <= SceneTuning.SEED_POINTS; i++)
			sum += p.point(i).distanceTo(q.point(i));
		return sum / (SceneTuning.SEED_POINTS + 1);
	}

	int doubtful() {
		int count = 0;
		for (final boolean s : stable)
			count += s ? 0 : 1;
		return count;
	}

	/** The higher, the better to start from. */
	double worth() {
		return Math.min(coverage, 1) - SceneTuning.SEED_DOUBT * doubtful();
	}
}
