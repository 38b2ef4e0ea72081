package io.github.knotresolver.track;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;

import io.github.knotresolver.candidate.CandidateSet;
import io.github.knotresolver.fit.FilamentEstimate;
import io.github.knotresolver.fit.Fit;
import io.github.knotresolver.fit.FitQuality;
import io.github.knotresolver.fit.NormalizedFrame;
import io.github.knotresolver.progress.Progress;

/**
 * The trellis of fits: the price of a vertex is its energy, that of an edge the motion.
 *
 * @param frames the frames
 * @param light their pixels, a strand's brightness 1
 * @param estimate line, length and fixed end
 * @param pools the fits of every frame
 * @param sets the candidates of every frame
 */
record FitTrellis(List<FrameView> frames, List<NormalizedFrame> light, FilamentEstimate estimate,
	List<List<Fit>> pools, List<CandidateSet> sets) {

	/** Where more than this share of the contour is in the dark, there is no filament. */
	private static final double LOST = 0.6;

	/** Where more than this share is in the dark, no contour can be trusted. */
	private static final double UNRESOLVED = 0.3;

	List<TrackedFrame> solve(final Set<Integer> corrected, final Progress progress) {
		final List<double[]> prices = pools.stream()
			.map(p -> p.stream().mapToDouble(Fit::energy).toArray()).toList();
		final MotionPrice motion = MotionPrice.learn(pools);
		final TrellisPath path = Trellis.solve(prices, (t, i, u, j) -> motion
			.between(pools.get(t).get(i).chain(), pools.get(u).get(j).chain()), progress);
		final List<Optional<FitQuality>> quality = new ArrayList<>();
		for (int t = 0; t < pools.size(); t++)
			quality.add(path.choice()[t] < 0
				? Optional.empty()
				: Optional.of(FitQuality.of(light.get(t), estimate.model(),
					pools.get(t).get(path.choice()[t]).chain())));
		final FitConfidence confidence = FitConfidence.learn(quality);
		final List<TrackedFrame> tracked = new ArrayList<>();
		for (int t = 0; t < pools.size(); t++)
			tracked.add(tracked(t, path, quality.get(t), confidence, corrected));
		return tracked;
	}

	private TrackedFrame tracked(final int t, final TrellisPath path,
		final Optional<FitQuality> quality, final FitConfidence confidence,
		final Set<Integer> corrected) {
		final int frame = frames.get(t).frame();
		if (quality.isEmpty() || quality.get().dark() > LOST)
			return TrackedFrame.without(frame, FrameStatus.LOST,
				"No filament was found in this frame.");
		if (quality.get().dark() > UNRESOLVED)
			return TrackedFrame.without(frame, FrameStatus.UNRESOLVED,
				"The best contour runs in the dark for " + Math.round(100 * quality.get().dark())
					+ " % of its length.");
		final Fit fit = pools.get(t).get(path.choice()[t]);
		final boolean given = corrected.contains(frame);
		return new TrackedFrame(frame, given ? FrameStatus.CORRECTED : FrameStatus.RESOLVED,
			Outcome.limitReason(sets.get(t).limited()), Optional.of(fit.chain().contour()),
			frames.get(t).graph().junctions(), pools.get(t).size(), fit.energy(),
			given ? 1 : confidence.of(FitConfidence.gap(path, pools.get(t), t), quality.get()));
	}
}
