package io.github.knotresolver.track;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;

import io.github.knotresolver.candidate.CandidateSet;
import io.github.knotresolver.fit.FilamentEstimate;
import io.github.knotresolver.fit.Fit;
import io.github.knotresolver.progress.Progress;

/** The trellis of fits: the price of a vertex is its energy, that of an edge the motion. */
record FitTrellis(List<FrameView> frames, FilamentEstimate estimate, List<List<Fit>> pools,
	List<CandidateSet> sets) {

	/** A gap of this price gives a confidence of 63 %. */
	private static final double GAP_SCALE = 1;

	List<TrackedFrame> solve(final Set<Integer> corrected, final Progress progress) {
		final List<double[]> prices = pools.stream()
			.map(p -> p.stream().mapToDouble(Fit::energy).toArray()).toList();
		final MotionPrice motion = MotionPrice.learn(pools);
		final TrellisPath path = Trellis.solve(prices, (t, i, u, j) -> motion
			.between(pools.get(t).get(i).chain(), pools.get(u).get(j).chain()), progress);
		final List<TrackedFrame> tracked = new ArrayList<>();
		for (int t = 0; t < pools.size(); t++)
			tracked.add(tracked(t, path, corrected));
		return tracked;
	}

	private TrackedFrame tracked(final int t, final TrellisPath path,
		final Set<Integer> corrected) {
		final int frame = frames.get(t).frame();
		if (path.choice()[t] < 0)
			return TrackedFrame.without(frame, FrameStatus.LOST,
				"No filament was found in this frame.");
		final Fit fit = pools.get(t).get(path.choice()[t]);
		return new TrackedFrame(frame,
			corrected.contains(frame) ? FrameStatus.CORRECTED : FrameStatus.RESOLVED,
			Outcome.limitReason(sets.get(t).limited()), Optional.of(fit.chain().polyline()),
			frames.get(t).graph().junctions(), pools.get(t).size(), fit.energy(),
			1 - Math.exp(-path.gap(t) / GAP_SCALE));
	}
}
