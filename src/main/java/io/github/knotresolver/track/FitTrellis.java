package io.github.knotresolver.track;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.BiFunction;
import java.util.stream.IntStream;

import io.github.knotresolver.candidate.CandidateSet;
import io.github.knotresolver.fit.Fit;
import io.github.knotresolver.fit.FitQuality;
import io.github.knotresolver.fit.NormalizedFrame;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.model.Alternative;
import io.github.knotresolver.model.FrameStatus;
import io.github.knotresolver.model.Observation;
import io.github.knotresolver.progress.Progress;

/**
 * The trellis of fits: the price of a vertex is its energy, that of an edge the motion.
 *
 * @param frames the frames
 * @param light their pixels, a strand's brightness 1
 * @param course what is known about the filament
 * @param pools the fits of every frame
 * @param sets the candidates of every frame
 * @param quality how well a fit agrees with the frame of an index
 */
record FitTrellis(List<FrameView> frames, List<NormalizedFrame> light, FilamentCourse course,
	List<List<Fit>> pools, List<CandidateSet> sets,
	BiFunction<Integer, Fit, FitQuality> quality) {

	/** So many other contours of a frame are kept. */
	private static final int ALTERNATIVES = 4;

	/** Where more than this share of the contour is in the dark, there is no filament. */
	private static final double LOST = 0.6;

	/** Where more than this share is in the dark, no contour can be trusted. */
	private static final double UNRESOLVED = 0.3;

	/** @return whether a contour of this quality may be shown */
	static boolean isTrusted(final FitQuality quality) {
		return quality.dark() <= UNRESOLVED;
	}

	/**
	 * @param said what the user said, by index of the frame
	 */
	List<Observation> solve(final Map<Integer, Restriction> said, final Progress progress) {
		final List<double[]> prices = pools.stream()
			.map(p -> p.stream().mapToDouble(Fit::energy).toArray()).toList();
		final MotionPrice motion = MotionPrice.learn(pools, course.anchor());
		final TrellisPath path = Trellis.solve(prices, (t, i, u, j) -> motion.between(
			course.anchor().carried(pools.get(t).get(i).chain(), t, u),
			pools.get(u).get(j).chain()), progress);
		final List<Optional<FitQuality>> quality = new ArrayList<>();
		for (int t = 0; t < pools.size(); t++)
			quality.add(path.choice()[t] < 0
				? Optional.empty()
				: Optional.of(this.quality.apply(t, pools.get(t).get(path.choice()[t]))));
		final FitConfidence confidence = FitConfidence.learn(quality);
		final List<Observation> tracked = new ArrayList<>();
		for (int t = 0; t < pools.size(); t++)
			tracked.add(tracked(t, path, quality.get(t), confidence,
				Optional.ofNullable(said.get(t))));
		return tracked;
	}

	private Observation tracked(final int t, final TrellisPath path,
		final Optional<FitQuality> quality, final FitConfidence confidence,
		final Optional<Restriction> said) {
		final int frame = frames.get(t).frame();
		final boolean lost = quality.isEmpty() || quality.get().dark() > LOST;
		final boolean dark = lost || quality.get().dark() > UNRESOLVED;
		final Optional<Polyline> given = said.flatMap(Restriction::contour);
		if (given.isPresent())
			return new Observation(frame, FrameStatus.CORRECTED, "Given by the user.",
				Optional.of(dark ? given.get() : chosen(t, path).chain().contour()), junctions(t),
				1, dark ? 0 : chosen(t, path).energy(), 1);
		if (said.isPresent() && pools.get(t).isEmpty())
			return Observation.without(frame, FrameStatus.UNRESOLVED, said.get().unmet());
		if (lost)
			return Observation.without(frame, FrameStatus.LOST,
				"No filament was found in this frame.");
		if (dark)
			return Observation.without(frame, FrameStatus.UNRESOLVED,
				"The best contour runs in the dark for " + Math.round(100 * quality.get().dark())
					+ " % of its length.");
		final Polyline contour = chosen(t, path).chain().contour();
		return new Observation(frame,
			said.isPresent() ? FrameStatus.CORRECTED : FrameStatus.RESOLVED,
			said.map(Restriction::met).orElse(Outcome.limitReason(sets.get(t).limited())), Optional.of(contour), junctions(t),
			pools.get(t).size(), chosen(t, path).energy(),
			confidence.of(FitConfidence.gap(path, pools.get(t), t), quality.get(),
				Uncovered.share(frames.get(t).graph(), contour)))
					.withAlternatives(alternatives(t, path));
	}

	/** The best of the other fits, at the price that the movie would have with them. */
	private List<Alternative> alternatives(final int t, final TrellisPath path) {
		final double[] through = path.through()[t];
		final List<Fit> shown = new ArrayList<>(List.of(chosen(t, path)));
		final List<Alternative> others = new ArrayList<>();
		IntStream.range(0, through.length).boxed()
			.sorted(Comparator.comparingDouble(v -> through[v])).map(v -> v.intValue())
			.filter(v -> FitConfidence.differs(pools.get(t).get(v), shown)).forEach(v -> {
				if (others.size() == ALTERNATIVES)
					return;
				final Fit fit = pools.get(t).get(v);
				shown.add(fit);
				others.add(new Alternative(fit.chain().contour(),
					chosen(t, path).energy() + Math.max(0, through[v] - path.total())));
			});
		return others;
	}

	private Fit chosen(final int t, final TrellisPath path) {
		return pools.get(t).get(path.choice()[t]);
	}

	private int junctions(final int t) {
		return frames.get(t).graph().junctions();
	}
}
