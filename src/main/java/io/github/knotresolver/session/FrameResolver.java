package io.github.knotresolver.session;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;

import net.imglib2.img.Img;
import net.imglib2.type.logic.BitType;

import io.github.knotresolver.candidate.CandidateGenerator;
import io.github.knotresolver.candidate.TrailCandidates;
import io.github.knotresolver.fit.LineModel;
import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.graph.GraphTuning;
import io.github.knotresolver.graph.SkeletonGraph;
import io.github.knotresolver.mask.Masks;
import io.github.knotresolver.mask.ObjectFollower;
import io.github.knotresolver.model.Constraint;
import io.github.knotresolver.model.Observation;
import io.github.knotresolver.model.Settings;
import io.github.knotresolver.model.Settings.CandidateMethod;
import io.github.knotresolver.model.Settings.ResolverMethod;
import io.github.knotresolver.model.UserException;
import io.github.knotresolver.paper.PaperCandidates;
import io.github.knotresolver.paper.PaperResolver;
import io.github.knotresolver.progress.Progress;
import io.github.knotresolver.progress.Workers;
import io.github.knotresolver.skeleton.Skeletonize;
import io.github.knotresolver.track.FitResolver;
import io.github.knotresolver.track.FitSolver;
import io.github.knotresolver.track.FrameGraph;
import io.github.knotresolver.track.FrameView;
import io.github.knotresolver.track.Resolver;
import io.github.knotresolver.track.ResolverQuery;
import io.github.knotresolver.track.StillerEnd;
import io.github.knotresolver.track.Track;
import io.github.knotresolver.track.TrellisResolver;

/**
 * Chooses the variants that the parameters ask for: the published method, ours on
 * skeletons alone, or ours with fits.
 */
final class FrameResolver {

	private final Settings parameters;
	private final Set<LineModel.Kind> kinds;
	private final List<FrameView> frames;
	private final Point fixedEnd;
	private final int binning;
	private final boolean alone;
	/** Our method, once it has looked at the movie. */
	private Optional<Optional<FitSolver>> solver = Optional.empty();

	/**
	 * @param parameters what is asked for
	 * @param kinds how strands may add up
	 * @param frames the frames to resolve, in order, at least one
	 * @param fixedEnd the fixed end in pixels
	 * @param binning edge of a pixel in pixels of the movie
	 * @param alone whether nothing speaks for other filaments in the movie
	 */
	FrameResolver(final Settings parameters, final Set<LineModel.Kind> kinds,
		final List<FrameView> frames, final Point fixedEnd, final int binning,
		final boolean alone) {
		this.parameters = parameters;
		this.kinds = kinds;
		this.frames = frames;
		this.fixedEnd = fixedEnd;
		this.binning = binning;
		this.alone = alone;
	}

	/**
	 * Resolves the frames. What a movie tells by itself is worked out once.
	 *
	 * @param said what the user said of the filament
	 * @return empty if there is no filament in any frame
	 */
	Optional<Track> resolve(final List<Constraint> said, final Workers workers,
		final Progress progress) {
		if (parameters.refine() && parameters.resolver() == ResolverMethod.MOVIE)
			return solver(workers, progress)
				.map(s -> s.doubtedIfWide(s.solve(said, workers, progress), binning))
				.map(t -> said.isEmpty() && parameters.fixedEnd().isEmpty()
					? t.withFrames(StillerEnd.doubted(t.frames()))
					: t);
		final Track track = onSkeletons(contours(said), workers, progress);
		return Optional.of(parameters.refine() ? refined(track, workers, progress) : track);
	}

	private Optional<FitSolver> solver(final Workers workers, final Progress progress) {
		if (solver.isEmpty()) {
			final FitResolver fits = fits(generator(), workers, progress);
			final Optional<FitSolver> first = fits.learn(frames, fixedEnd, parameters.length());
			final Optional<Point> other = parameters.fixedEnd().isPresent()
				? Optional.empty()
				: first.flatMap(
					s -> StillerEnd.of(frames, s.solve(List.of(), workers, progress).frames()));
			solver = Optional.of(
				other.isPresent() ? fits.learn(frames, other.get(), parameters.length()) : first);
		}
		return solver.get();
	}

	private FitResolver fits(final CandidateGenerator proposer, final Workers workers,
		final Progress progress) {
		final FitResolver fits = new FitResolver(proposer, kinds, parameters.lengthModel(), workers,
			progress);
		return alone ? fits : fits.besideOthers();
	}

	/** What works on skeletons knows whole contours only. */
	private static Map<Integer, Polyline> contours(final List<Constraint> said) {
		final Map<Integer, Polyline> contours = new HashMap<>();
		for (final Constraint c : said) {
			if (c.kind() != Constraint.Kind.CONTOUR)
				throw new UserException("The correction of frame " + c.frame() + " is of the kind "
					+ c.kind().label()
					+ ", but skeletons alone take whole contours only; draw the whole contour, or resolve with resolver=movie and refine.");
			contours.put(c.frame(), c.shape());
		}
		return contours;
	}

	private Track onSkeletons(final Map<Integer, Polyline> corrections, final Workers workers,
		final Progress progress) {
		progress.report("Resolving", 0);
		final Resolver resolver = parameters.resolver() == ResolverMethod.PAPER
			? new PaperResolver(generator())
			: new TrellisResolver(generator(), TrellisResolver.DEFAULT_MOTION, workers);
		return resolver.resolve(
			new ResolverQuery(followed(workers), fixedEnd, parameters.length(), corrections),
			progress);
	}

	/** The graph of the filament alone, which is followed from frame to frame. */
	private List<FrameGraph> followed(final Workers workers) {
		final List<Img<BitType>> masks = frames.stream().map(FrameView::mask).toList();
		final List<Optional<Img<BitType>>> found = parameters.isPublished()
			? ObjectFollower.follow(masks, fixedEnd)
			: ObjectFollower.followClamped(masks, fixedEnd, GraphTuning.NEAR_CLAMP);
		return workers.map(frames.size(),
			t -> new FrameGraph(frames.get(t).frame(),
				found.get(t).map(m -> SkeletonGraph.of(skeleton(frames.get(t), m),
					SkeletonGraph.DEFAULT_SPUR_LENGTH, List.of(fixedEnd)))));
	}

	/** The middle line of an object: the evidence's, if there is one. */
	private static Img<BitType> skeleton(final FrameView frame, final Img<BitType> object) {
		return frame.evidence().map(e -> Masks.and(e.skeleton(), object))
			.orElseGet(() -> Skeletonize.thin(object));
	}

	/**
	 * The same contours, fitted to the picture; as they were where the user gave them or no
	 * fit is good; frames without one stay without.
	 */
	private Track refined(final Track track, final Workers workers, final Progress progress) {
		final Set<Integer> present = track.frames().stream()
			.filter(f -> f.contour().filter(c -> c.length() > 1).isPresent())
			.map(Observation::frame).collect(Collectors.toSet());
		final List<FrameView> seen = frames.stream().filter(f -> present.contains(f.frame()))
			.toList();
		return seen.isEmpty()
			? track
			: fits(TrailCandidates.DEFAULT, workers, progress)
				.refine(seen, track, fixedEnd, parameters.length()).orElse(track);
	}

	private CandidateGenerator generator() {
		return parameters.candidates() == CandidateMethod.PAPER
			? PaperCandidates.DEFAULT
			: TrailCandidates.DEFAULT;
	}
}
