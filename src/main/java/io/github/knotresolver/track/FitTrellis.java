package io.github.knotresolver.track;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.BiFunction;
import java.util.stream.IntStream;

import io.github.knotresolver.candidate.CandidateSet;
import io.github.knotresolver.fit.Chain;
import io.github.knotresolver.fit.Fit;
import io.github.knotresolver.fit.FitQuality;
import io.github.knotresolver.fit.NormalizedFrame;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.geometry.RobustStatistics;
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
 * @param looks gives a look at a fit in a frame
 * @param freeLength whether each fit has a length of its own
 */
record FitTrellis(List<FrameView> frames, List<NormalizedFrame> light, FilamentCourse course,
	List<List<Fit>> pools, List<CandidateSet> sets, BiFunction<Integer, Fit, FitLook> looks,
	boolean freeLength) {

	/** @return whether a contour of this quality may be shown */
	static boolean isTrusted(final FitQuality quality) {
		return quality.dark() <= TrackTuning.UNRESOLVED_DARK;
	}

	/**
	 * The movie as chosen.
	 *
	 * @param frames one for each frame
	 * @param evidence what can be seen of each frame's contour; empty where there is none
	 * @param lengths of the chosen chains in pixels; NaN where there is none
	 * @param looks at the chosen chains; empty where there is none
	 * @param elsewhere in how many frames contours do not end where their light does, as a figure
	 * @param price of the movie, without that of changing course
	 */
	record Solved(List<Observation> frames, List<Optional<FitEvidence>> evidence, double[] lengths,
		List<Optional<FitLook>> looks, double elsewhere, double price) {
	}

	/**
	 * @param said what the user said, by index of the frame
	 */
	Solved solve(final Map<Integer, Restriction> said, final Progress progress) {
		final MotionPrice motion = MotionPrice.learn(pools, course.anchor());
		final Course ways = freeLength
			? plain(pools, course.anchor(), motion, progress)
			: course(pools, course.anchor(), motion, progress);
		final TrellisPath path = ways.path();
		final List<Optional<FitLook>> seen = new ArrayList<>();
		for (int t = 0; t < pools.size(); t++) {
			progress.checkCancelled();
			seen.add(path.choice()[t] < 0
				? Optional.empty()
				: Optional.of(looks.apply(t, chosen(t, path))));
		}
		final List<FitLook> all = seen.stream().flatMap(Optional::stream).toList();
		final double elsewhere = FitLook.elsewhere(all),
			astray = light.stream().anyMatch(NormalizedFrame::isClipped)
				// Beside lines that were cut off it is not known what light is theirs.
				? elsewhere
				: Math.max(elsewhere, FitLook.leavesOut(all));
		final double pattern = RobustStatistics
			.upperMedian(all.stream().mapToDouble(l -> pattern(l)).toArray(), 0);
		final FitConfidence confidence = FitConfidence
			.learn(seen.stream().map(s -> s.map(FitLook::quality)).toList());
		final boolean[] guessed = ExchangedOrder.guessed(path, pools,
			course.estimate().model().sigma());
		final List<Observation> tracked = new ArrayList<>();
		final List<Optional<FitEvidence>> evidence = new ArrayList<>();
		for (int t = 0; t < pools.size(); t++) {
			final int frame = t;
			evidence.add(seen.get(t).filter(s -> isTrusted(s.quality()))
				.map(s -> evidence(frame, path, s, new Rest(confidence, motion, astray, pattern))));
			final Observation here = tracked(t, path, seen.get(t).map(FitLook::quality),
				evidence.get(t), Optional.ofNullable(said.get(t)));
			tracked.add(guessed[t] ? here.doubted(TrackTuning.GUESSED, ExchangedOrder.WHY) : here);
		}
		return new Solved(tracked, evidence,
			IntStream.range(0, pools.size())
				.mapToDouble(
					t -> path.choice()[t] < 0 ? Double.NaN : chosen(t, path).chain().length())
				.toArray(),
			seen, elsewhere, ways.plain());
	}

	/**
	 * A way through fits.
	 *
	 * @param path the cheapest
	 * @param plain price of the cheapest if changing course costs nothing
	 */
	record Course(TrellisPath path, double plain) {
	}

	/**
	 * The cheapest way through fits. It costs to change course.
	 *
	 * @param pools the fits of every frame
	 * @param anchor where the fixed end is
	 * @param motion what motion costs
	 */
	static Course course(final List<List<Fit>> pools, final AnchorPath anchor,
		final MotionPrice motion, final Progress progress) {
		final Course plain = plain(pools, anchor, motion, progress);
		final int[] choice = plain.path.choice();
		final Inertia inertia = new Inertia(IntStream.range(0, pools.size())
			.mapToObj(t -> choice[t] < 0
				? Optional.<Chain>empty()
				: Optional.of(pools.get(t).get(choice[t]).chain()))
			.toList(), anchor);
		return new Course(
			SmoothTrellis.solve(plain.path, prices(pools), motion(pools, anchor, motion),
				(t, i, j, k) -> inertia.price(t + 1, pools.get(t).get(i).chain(),
					pools.get(t + 1).get(j).chain(), pools.get(t + 2).get(k).chain()),
				progress),
			plain.plain);
	}

	/** The same without inertia: if each fit has a length of its own, so has its motion. */
	private static Course plain(final List<List<Fit>> pools, final AnchorPath anchor,
		final MotionPrice motion, final Progress progress) {
		final TrellisPath path = Trellis.solve(prices(pools), motion(pools, anchor, motion),
			progress);
		return new Course(path, path.total());
	}

	private static List<double[]> prices(final List<List<Fit>> pools) {
		return pools.stream().map(p -> p.stream().mapToDouble(Fit::energy).toArray()).toList();
	}

	private static Trellis.EdgePrice motion(final List<List<Fit>> pools, final AnchorPath anchor,
		final MotionPrice motion) {
		return (t, i, u, j) -> motion.between(anchor.carried(pools.get(t).get(i).chain(), t, u),
			pools.get(u).get(j).chain());
	}

	private Observation tracked(final int t, final TrellisPath path,
		final Optional<FitQuality> quality, final Optional<FitEvidence> evidence,
		final Optional<Restriction> said) {
		final int frame = frames.get(t).frame();
		final Optional<Polyline> given = said.flatMap(Restriction::contour);
		if (given.isPresent())
			return new Observation(frame, FrameStatus.CORRECTED, Observation.GIVEN,
				Optional.of(evidence.isEmpty() ? given.get() : chosen(t, path).chain().contour()),
				junctions(t), 1, evidence.isEmpty() ? 0 : chosen(t, path).energy(), 1);
		if (said.isPresent() && pools.get(t).isEmpty())
			return Observation.without(frame, FrameStatus.UNRESOLVED, said.get().unmet());
		if (quality.isEmpty() || quality.get().dark() > TrackTuning.LOST_DARK)
			return Observation.without(frame, FrameStatus.LOST, Observation.NOT_FOUND);
		if (evidence.isEmpty())
			return Observation.without(frame, FrameStatus.UNRESOLVED,
				"The best contour runs in the dark for " + Math.round(100 * quality.get().dark())
					+ " % of its length.");
		return seen(t, path, evidence.get(), said);
	}

	private Observation seen(final int t, final TrellisPath path, final FitEvidence evidence,
		final Optional<Restriction> said) {
		final int frame = frames.get(t).frame();
		final double most = FitConfidence.atMost(path, pools.get(t), t,
			course.estimate().model().sigma());
		final double confidence = Math.min(FitConfidence.of(evidence), most);
		final String doubt = FitConfidence.reason(evidence, most);
		if (said.isEmpty() && confidence < TrackTuning.NO_CONFIDENCE)
			return Observation.without(frame, FrameStatus.UNRESOLVED,
				doubt.replace("Doubtful: ", "No contour can be trusted: "));
		final Visible visible = Visible.of(chosen(t, path).chain().contour(), light.get(t));
		if (said.isEmpty()
			&& visible.contour().length() < TrackTuning.SPOT * course.estimate().model().sigma())
			return Observation.without(frame, FrameStatus.UNRESOLVED,
				"What is seen of the contour is too short to be told from a spot.");
		final String limit = sets.get(t).limitReason();
		return new Observation(frame,
			said.isPresent() ? FrameStatus.CORRECTED : FrameStatus.RESOLVED,
			said.map(Restriction::met).orElse((doubt + " " + limit).trim()),
			Optional.of(visible.contour()), junctions(t), pools.get(t).size(),
			chosen(t, path).energy(), confidence).withVisible(visible.share())
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
				if (others.size() == TrackTuning.ALTERNATIVES)
					return;
				final Fit fit = pools.get(t).get(v);
				shown.add(fit);
				others.add(new Alternative(fit.chain().contour(),
					chosen(t, path).energy() + Math.max(0, through[v] - path.total())));
			});
		return others;
	}

	/** What the whole movie says. */
	private record Rest(FitConfidence confidence, MotionPrice motion, double astray,
		double pattern) {
	}

	private FitEvidence evidence(final int t, final TrellisPath path, final FitLook look,
		final Rest rest) {
		return new FitEvidence(FitConfidence.rival(FitConfidence.gap(path, pools.get(t), t)),
			rest.confidence.misfit(look.quality()), pattern(look), look.quality().dark(),
			look.residue().unexplained(), look.residue().invented(), look.beyond(), look.missing(),
			look.uncovered(), jump(t, path, rest.motion), FitEvidence.faint(course.noise()),
			FitEvidence.folded(SharpestTurn.of(chosen(t, path).chain().contour(),
				course.estimate().model().sigma())),
			rest.astray, FitEvidence.worse(pattern(look), rest.pattern));
	}

	private static double pattern(final FitLook look) {
		return Math.log(Math.max(1, look.residue().pattern()));
	}

	/** How much farther than usual the chosen chain moved, from the frame before or to the next. */
	private double jump(final int t, final TrellisPath path, final MotionPrice motion) {
		double most = 1;
		for (final int u : new int[]{t - 1, t + 1})
			if (u >= 0 && u < pools.size() && path.choice()[u] >= 0)
				most = Math.max(most,
					motion.multiple(course.anchor().carried(chosen(t, path).chain(), t, u),
						chosen(u, path).chain()));
		return Math.log(most);
	}

	private Fit chosen(final int t, final TrellisPath path) {
		return pools.get(t).get(path.choice()[t]);
	}

	private int junctions(final int t) {
		return frames.get(t).graph().junctions();
	}
}
