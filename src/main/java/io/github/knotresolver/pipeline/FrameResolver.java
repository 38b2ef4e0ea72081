package io.github.knotresolver.pipeline;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;

import net.imglib2.img.Img;
import net.imglib2.type.logic.BitType;

import io.github.knotresolver.candidate.CandidateGenerator;
import io.github.knotresolver.candidate.TrailCandidates;
import io.github.knotresolver.fit.LineModel;
import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.graph.SkeletonGraph;
import io.github.knotresolver.mask.Masks;
import io.github.knotresolver.mask.ObjectFollower;
import io.github.knotresolver.model.CandidateMethod;
import io.github.knotresolver.model.FrameStatus;
import io.github.knotresolver.model.Observation;
import io.github.knotresolver.model.ResolverMethod;
import io.github.knotresolver.model.Settings;
import io.github.knotresolver.paper.PaperCandidates;
import io.github.knotresolver.paper.PaperResolver;
import io.github.knotresolver.progress.Progress;
import io.github.knotresolver.progress.Workers;
import io.github.knotresolver.skeleton.Skeletonize;
import io.github.knotresolver.track.FitResolver;
import io.github.knotresolver.track.FitResolver.Resolved;
import io.github.knotresolver.track.FrameGraph;
import io.github.knotresolver.track.FrameView;
import io.github.knotresolver.track.Resolver;
import io.github.knotresolver.track.ResolverQuery;
import io.github.knotresolver.track.Track;
import io.github.knotresolver.track.TrellisResolver;

/**
 * Chooses the variants that the parameters ask for: the published method, ours on
 * skeletons alone, or ours with fits.
 */
final class FrameResolver {

	/** A clamped filament's mask begins this near (pixels) to its fixed end. */
	private static final double REACH = 12;

	private final Settings parameters;
	private final Set<LineModel.Kind> kinds;
	private final Workers workers;
	private final Progress progress;

	FrameResolver(final Settings parameters, final Set<LineModel.Kind> kinds,
		final Workers workers, final Progress progress) {
		this.parameters = parameters;
		this.kinds = kinds;
		this.workers = workers;
		this.progress = progress;
	}

	/** What was found: length in pixels and its standard error, NaN if not known. */
	record Found(Point fixedEnd, double length, double lengthError, List<Observation> frames,
		List<String> notes) {
	}

	/** Resolves the frames; empty if there is no filament in any. */
	Optional<Found> resolve(final List<FrameView> frames, final Point fixedEnd) {
		if (parameters.refine() && parameters.resolver() == ResolverMethod.MOVIE)
			return fitted(generator(), frames, fixedEnd, parameters.corrections())
				.map(FrameResolver::found);
		final Found track = found(fixedEnd, onSkeletons(frames, fixedEnd));
		return Optional.of(parameters.refine() ? refined(frames, track) : track);
	}

	private Optional<Resolved> fitted(final CandidateGenerator proposer,
		final List<FrameView> frames, final Point fixedEnd, final Map<Integer, Polyline> given) {
		return new FitResolver(proposer, kinds, parameters.lengthModel(),
			workers, progress).resolve(frames, fixedEnd, parameters.length(), given);
	}

	private Track onSkeletons(final List<FrameView> frames, final Point fixedEnd) {
		progress.report("Resolving", 0);
		final Resolver resolver = parameters.resolver() == ResolverMethod.PAPER
			? new PaperResolver(generator())
			: new TrellisResolver(generator(), TrellisResolver.DEFAULT_MOTION, workers);
		return resolver.resolve(new ResolverQuery(followed(frames, fixedEnd), fixedEnd,
			parameters.length(), parameters.corrections()), progress);
	}

	/** The graph of the filament alone, which is followed from frame to frame. */
	private List<FrameGraph> followed(final List<FrameView> frames, final Point fixedEnd) {
		final List<Img<BitType>> masks = frames.stream().map(FrameView::mask).toList();
		final List<Optional<Img<BitType>>> found = parameters.isPublished()
			? ObjectFollower.follow(masks, fixedEnd)
			: ObjectFollower.followClamped(masks, fixedEnd, REACH);
		return workers.map(frames.size(),
			t -> new FrameGraph(frames.get(t).frame(), found.get(t).map(m -> SkeletonGraph.of(
				skeleton(frames.get(t), m), SkeletonGraph.DEFAULT_SPUR_LENGTH, List.of(fixedEnd)))));
	}

	/** The middle line of an object: the evidence's, if there is one. */
	private static Img<BitType> skeleton(final FrameView frame, final Img<BitType> object) {
		return frame.evidence().map(e -> Masks.and(e.skeleton(), object))
			.orElseGet(() -> Skeletonize.thin(object));
	}

	/** The same contours, fitted to the picture; frames without one stay without. */
	private Found refined(final List<FrameView> frames, final Found track) {
		final Map<Integer, Polyline> contours = new HashMap<>();
		track.frames.forEach(f -> f.contour().filter(c -> c.length() > 1)
			.ifPresent(c -> contours.put(f.frame(), c)));
		final List<FrameView> seen = frames.stream().filter(f -> contours.containsKey(f.frame()))
			.toList();
		return seen.isEmpty()
			? track
			: fitted(TrailCandidates.DEFAULT, seen, track.fixedEnd, contours)
				.map(r -> merged(track, r)).orElse(track);
	}

	private static Found merged(final Found track, final Resolved fits) {
		final Map<Integer, Observation> byFrame = new HashMap<>();
		fits.frames().forEach(f -> byFrame.put(f.frame(), f));
		final List<Observation> frames = new ArrayList<>();
		for (final Observation f : track.frames)
			frames.add(refined(f, byFrame.get(f.frame())));
		return new Found(fits.estimate().fixedEnd(), fits.estimate().length(),
			fits.estimate().lengthError(), frames, track.notes);
	}

	/** A frame's contour as fitted; as it was where the user gave it or no fit is good. */
	private static Observation refined(final Observation frame, final Observation fit) {
		return fit == null || fit.contour().isEmpty() || frame.status() == FrameStatus.CORRECTED
			? frame
			: frame.withContour(fit.contour().get());
	}

	private static Found found(final Resolved r) {
		final List<String> notes = new ArrayList<>(
			List.of("Line model: " + r.estimate().model() + "."));
		notes.addAll(r.notes());
		return new Found(r.estimate().fixedEnd(), r.estimate().length(), r.estimate().lengthError(),
			r.frames(), notes);
	}

	private static Found found(final Point fixedEnd, final Track track) {
		return new Found(fixedEnd, track.length().orElse(Double.NaN), Double.NaN, track.frames(),
			track.frames().stream().noneMatch(f -> f.status() == FrameStatus.UNRESOLVED)
				? List.of()
				: List.of("Some frames could not be resolved; frames.csv says why."));
	}

	private CandidateGenerator generator() {
		return parameters.candidates() == CandidateMethod.PAPER
			? PaperCandidates.DEFAULT
			: TrailCandidates.DEFAULT;
	}
}
