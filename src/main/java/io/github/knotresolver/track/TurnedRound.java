package io.github.knotresolver.track;

import java.util.ArrayList;
import java.util.List;

import io.github.knotresolver.contour.EqualArcDistance;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.model.Observation;

/**
 * Whether a filament's contours were turned round somewhere in the movie: from one to the next it
 * moved far, but hardly at all if the next one ran from its other end. Which of its two ends is
 * first is then not known in the frames that run the other way than most, nor beside the place.
 */
final class TurnedRound {

	private static final String WHY = "Doubtful: the ends may be exchanged here; turned round, the contour fits those of other frames better.";

	private TurnedRound() {
	}

	/**
	 * Takes the confidence off what may be turned round. O(frames * length).
	 *
	 * @param frames of one filament, in order of time
	 * @return the same contours, none of which is believed where it may be turned round
	 */
	static List<Observation> doubted(final List<Observation> frames) {
		final List<Integer> seen = new ArrayList<>();
		for (int t = 0; t < frames.size(); t++)
			if (frames.get(t).contour().isPresent())
				seen.add(t);
		final boolean[] turned = new boolean[seen.size()], beside = new boolean[seen.size()];
		int count = 0;
		for (int k = 1; k < turned.length; k++) {
			final boolean here = isTurned(frames.get(seen.get(k - 1)).contour().orElseThrow(),
				frames.get(seen.get(k)).contour().orElseThrow());
			turned[k] = turned[k - 1] ^ here;
			beside[k] |= here;
			beside[k - 1] |= here;
			count += turned[k] ? 1 : 0;
		}
		final boolean seldom = 2 * count <= turned.length;
		final List<Observation> doubted = new ArrayList<>(frames);
		for (int k = 0; k < turned.length; k++)
			if (beside[k] || turned[k] == seldom)
				doubted.set(seen.get(k), frames.get(seen.get(k)).doubted(TrackTuning.TURNED, WHY));
		return doubted;
	}

	private static boolean isTurned(final Polyline before, final Polyline after) {
		final double moved = EqualArcDistance.mean(before, after);
		return moved > TrackTuning.VISIBLE
			&& EqualArcDistance.mean(before, after.reversed()) < TrackTuning.TURN * moved;
	}
}
