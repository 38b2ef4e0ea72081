package io.github.knotresolver.track;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.EnumSet;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.TreeMap;
import java.util.function.IntFunction;
import java.util.stream.IntStream;

import io.github.knotresolver.candidate.CandidateGenerator;
import io.github.knotresolver.candidate.CandidateQuery;
import io.github.knotresolver.candidate.CandidateSet;
import io.github.knotresolver.fit.FilamentEstimate;
import io.github.knotresolver.fit.FilamentEstimator;
import io.github.knotresolver.fit.FilamentFitter;
import io.github.knotresolver.fit.Fit;
import io.github.knotresolver.fit.FitQuality;
import io.github.knotresolver.fit.FitSettings;
import io.github.knotresolver.fit.LineModel;
import io.github.knotresolver.fit.NormalizedFrame;
import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.model.Settings.LengthModel;
import io.github.knotresolver.progress.Progress;
import io.github.knotresolver.progress.Workers;
import io.github.knotresolver.track.FilamentLearner.Seen;

/**
 * Our method, with fits: the graph proposes, the fit decides, the trellis settles. Line and
 * length are learned from the clearest frames; hypotheses are carried through the
 * movie in both directions of time, joined in every frame by fits of the graph's
 * candidates; the cheapest path through all fits of all frames is the movie.
 */
public final class FitResolver {

	private final CandidateGenerator generator;
	private final Set<LineModel.Kind> kinds;
	private final FilamentLearner learner;
	private final LengthModel lengths;
	/** Whether nothing else is in the movie, so that what carries the fixed end along is the stage. */
	private final boolean alone;
	private final Workers workers;
	private final Progress progress;

	/**
	 * @param generator proposes contours
	 * @param kinds how strands may add up in this movie, at least one
	 * @param lengths whether the filament may grow and shrink
	 * @param workers threads
	 * @param progress told how far the work is, and asked whether to stop
	 */
	public FitResolver(final CandidateGenerator generator, final Set<LineModel.Kind> kinds,
		final LengthModel lengths, final Workers workers, final Progress progress) {
		this(generator, kinds, lengths, true, workers, progress);
	}

	private FitResolver(final CandidateGenerator generator, final Set<LineModel.Kind> kinds,
		final LengthModel lengths, final boolean alone, final Workers workers,
		final Progress progress) {
		this.generator = generator;
		this.kinds = EnumSet.copyOf(kinds);
		learner = new FilamentLearner(this.kinds, lengths, workers, progress);
		this.lengths = lengths;
		this.alone = alone;
		this.workers = workers;
		this.progress = progress;
	}

	/**
	 * The same for a filament beside others, which may glide: a fixed end that seems to go far, one
	 * way, may be one of theirs.
	 *
	 * @return another resolver, with the same threads
	 */
	public FitResolver besideOthers() {
		return new FitResolver(generator, kinds, lengths, false, workers, progress);
	}

	/**
	 * Finds out all that a movie tells by itself.
	 *
	 * @param frames the frames to resolve, in order of time, at least one
	 * @param fixedEnd the fixed end in pixels, to within a few
	 * @param length the filament's length in pixels; empty to estimate it
	 * @return what answers for the movie; empty if there is no filament in any frame
	 */
	public Optional<FitSolver> learn(final List<FrameView> frames, final Point fixedEnd,
		final OptionalDouble length) {
		return look(frames, fixedEnd, length)
			.map(seen -> length.isPresent() || lengths == LengthModel.FREE
				? new FitSolver(pools(seen))
				: settled(seen));
	}

	private FitSolver settled(final Seen seen) {
		final Again steady = steadyIfAsGood(seen);
		return settled(steady.seen, steady.solver);
	}

	/**
	 * A length that changes must explain the movie better than one that does not: haze that an end
	 * comes into looks like growth, a tip that lies on the filament as if it broke.
	 */
	private Again steadyIfAsGood(final Seen seen) {
		final FitSolver first = new FitSolver(pools(seen));
		final FilamentCourse course = seen.course();
		if (course.length().kind() == LengthCourse.Kind.CONSTANT)
			return new Again(seen, first);
		final LengthCourse level = course.length().levelled();
		final Seen same = seen.withCourse(course.withLength(level)
			.withEstimate(course.estimate().withLength(level.of(0), Double.NaN)));
		final FitSolver other = new FitSolver(pools(same));
		return first.solved(progress).price() < other.solved(progress).price()
			- TrackTuning.HOPELESS ? new Again(seen, first) : new Again(same, other);
	}

	private FitSolver settled(final Seen seen, final FitSolver first) {
		return learner.again(seen, first)
			.map(other -> new Again(other, new FitSolver(pools(other))))
			.filter(again -> again.solver.price(progress) < first.price(progress))
			.map(again -> withLengthThatHolds(again.seen, again.solver))
			.orElseGet(() -> withLengthThatHolds(seen, first));
	}

	/** A movie that was looked at again, and who answers then. */
	private record Again(Seen seen, FitSolver solver) {
	}

	/**
	 * Where contours often do not end with their light, the length is not right; a filament that
	 * lies on itself in nearly all frames may grow or break unseen. There fits of free length say
	 * how long it is.
	 */
	private FitSolver withLengthThatHolds(final Seen seen, final FitSolver first) {
		final FitTrellis.Solved solved = first.solved(progress);
		if (solved.elsewhere() == 0 || lengths != LengthModel.AUTO)
			return first.withLengthOfAll(workers, progress);
		final FitResolver free = new FitResolver(generator, kinds, LengthModel.FREE, alone, workers,
			progress);
		return Lengths.found(new FitSolver(free.pools(seen)).solved(progress), seen.course())
			.stream().map(course -> steadyIfAsGood(seen.withCourse(course)).solver)
			.filter(again -> again.solved(progress).price() < solved.price() - TrackTuning.HOPELESS)
			.findFirst().orElseGet(() -> first.withLengthOfAll(workers, progress));
	}

	/**
	 * Fits contours that are known to be right, but to a pixel, to the pictures.
	 *
	 * @param frames those that have one, longer than a pixel, in order of time, at least one
	 * @param track the contours, fixed end first
	 * @param fixedEnd the fixed end in pixels, to within a few
	 * @param length the filament's length in pixels; empty to estimate it
	 * @return the same contours, sub-pixel, where the user did not give them and the picture confirms
	 *         the fit; empty if the frames show no filament
	 */
	public Optional<Track> refine(final List<FrameView> frames, final Track track,
		final Point fixedEnd, final OptionalDouble length) {
		return look(frames, fixedEnd, length)
			.map(seen -> track.fitted(seen.course().estimate(), fitted(seen, track)));
	}

	/** What the picture confirms, by 1-based frame. */
	private Map<Integer, Polyline> fitted(final Seen seen, final Track track) {
		final Map<Integer, Polyline> contours = new HashMap<>();
		track.frames().forEach(f -> f.contour().ifPresent(c -> contours.put(f.frame(), c)));
		final List<NormalizedFrame> light = FilamentLearner.light(seen.frames(),
			seen.course().estimate());
		final int links = FilamentEstimator.links(seen.course().estimate().length());
		final List<Fit> fits = workers.map("Fitting the contours", progress, seen.frames().size(),
			t -> new FitProposals(seen.frames().get(t), seen.course().in(t), links,
				settings(seen.course()).freeLength())
				.of(contours.get(seen.frames().get(t).frame()),
					fitter(t, light, seen.course(), settings(seen.course())))
				.get(0));
		final Map<Integer, Polyline> fitted = new TreeMap<>();
		for (int t = 0; t < fits.size(); t++)
			if (FitTrellis.isTrusted(
				FitQuality.of(light.get(t), seen.course().estimate().model(), fits.get(t).chain())))
				fitted.put(seen.frames().get(t).frame(), fits.get(t).chain().contour());
		return fitted;
	}

	private Optional<Seen> look(final List<FrameView> frames, final Point fixedEnd,
		final OptionalDouble length) {
		final AnchorPath ends = AnchorPath.follow(frames, fixedEnd, progress);
		return learner.look(frames, candidates(frames, ends::at, t -> OptionalDouble.empty()), ends,
			fixedEnd, length);
	}

	private FitPools pools(final Seen seen) {
		final FitPools first = proposed(seen.frames(), seen.course());
		final FitPools best = seen.endIsDoubtful() && seen.course().anchor().range() > 0
			? first.orStill(proposed(seen.frames(), seen.still()))
			: first;
		final FilamentCourse settled = best.withAnchorOfAll(seen.endIsDoubtful(), alone, workers,
			progress);
		return new FitPools(best.frames(), best.light(), settled, best.sets(), pools(best.light(),
			settled,
			settled == best.course() ? best.fits() : repriced(best.fits(), best.light(), settled)),
			best.settings()).withJumps(workers, progress).withExchanges(workers, progress);
	}

	/** The graph's proposals for a course, fitted. */
	private FitPools proposed(final List<FrameView> frames, final FilamentCourse course) {
		final boolean free = lengths == LengthModel.FREE;
		final List<CandidateSet> sets = candidates(frames, course.anchor()::at,
			t -> free ? OptionalDouble.empty() : OptionalDouble.of(course.in(t).length()));
		final List<NormalizedFrame> light = FilamentLearner.light(frames, course.estimate());
		return new FitPools(frames, light, course, sets, proposals(frames, light, course, sets),
			settings(course));
	}

	/** The same fits, at the price of another anchor. */
	private List<List<Fit>> repriced(final List<List<Fit>> fits, final List<NormalizedFrame> light,
		final FilamentCourse course) {
		return workers.map(fits.size(), t -> {
			final FilamentFitter fitter = fitter(t, light, course, settings(course));
			return fits.get(t).stream().map(f -> fitter.price(f.chain())).toList();
		});
	}

	private FitSettings settings(final FilamentCourse course) {
		return FitSettings.DEFAULT.withStiffness(course.stiffness())
			.withFreeLength(lengths == LengthModel.FREE);
	}

	private CandidateSet candidates(final FrameView frame, final FilamentEstimate estimate) {
		return generator.generate(CandidateQuery.of(frame.graph(), estimate.fixedEnd(),
			OptionalDouble.of(estimate.length())), progress);
	}

	private List<CandidateSet> candidates(final List<FrameView> frames,
		final IntFunction<Point> fixedEnds, final IntFunction<OptionalDouble> known) {
		return workers.map("Proposing contours", progress, frames.size(),
			t -> generator.generate(
				CandidateQuery.of(frames.get(t).graph(), fixedEnds.apply(t), known.apply(t)),
				progress));
	}

	private List<List<Fit>> proposals(final List<FrameView> frames,
		final List<NormalizedFrame> light, final FilamentCourse course,
		final List<CandidateSet> sets) {
		final int links = FilamentEstimator.links(course.estimate().length());
		final FitSettings rough = settings(course).roughAndStiff(FitSettings.START_STIFFNESS);
		return workers.map("Fitting the proposals", progress, frames.size(), t -> {
			final FilamentFitter fitter = fitter(t, light, course, settings(course));
			final FitProposals proposer = new FitProposals(frames.get(t), course.in(t), links,
				settings(course).freeLength());
			final FilamentFitter stiff = fitter(t, light, course, rough,
				FitProposals.stiffLinks(links));
			final List<Fit> fits = new ArrayList<>(proposer.of(sets.get(t), fitter, stiff));
			if (course.length().isOpen(t))
				fits.addAll(new FitProposals(frames.get(t), course.otherIn(t), links, false)
					.of(candidates(frames.get(t), course.otherIn(t)), fitter, stiff));
			fits.stream().min(Comparator.comparingDouble(Fit::energy)).ifPresent(
				best -> progress.sighted(frames.get(t).frame(), List.of(best.chain().contour())));
			return fits;
		});
	}

	private List<List<Fit>> pools(final List<NormalizedFrame> light, final FilamentCourse course,
		final List<List<Fit>> proposals) {
		final int n = proposals.size();
		final Propagation propagation = new Propagation(TrackTuning.HYPOTHESES,
			MotionPrice.learn(proposals, course.anchor()),
			t -> fitter(t, light, course, settings(course)), proposals,
			new Propagation.Frames(course, settings(course).freeLength()), progress);
		final List<List<List<Fit>>> walks = workers.map(2, direction -> propagation
			.walk(IntStream.range(0, n).map(i -> direction == 0 ? i : n - 1 - i).toArray()));
		final List<List<Fit>> pools = new ArrayList<>();
		for (int t = 0; t < n; t++) {
			final FitPool pool = new FitPool();
			proposals.get(t).forEach(pool::add);
			walks.get(0).get(t).forEach(pool::add);
			walks.get(1).get(n - 1 - t).forEach(pool::add);
			pools.add(pool.fits());
		}
		return pools;
	}

	private static FilamentFitter fitter(final int t, final List<NormalizedFrame> light,
		final FilamentCourse course, final FitSettings settings) {
		return fitter(t, light, course, settings,
			FilamentEstimator.links(course.estimate().length()));
	}

	private static FilamentFitter fitter(final int t, final List<NormalizedFrame> light,
		final FilamentCourse course, final FitSettings settings, final int links) {
		return new FilamentFitter(light.get(t), course.estimate().model(), links,
			Optional.of(course.anchor().at(t)),
			settings.withClampWeight(course.anchor().weight(t)));
	}
}
