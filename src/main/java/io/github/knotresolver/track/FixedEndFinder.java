package io.github.knotresolver.track;

import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;

import io.github.knotresolver.candidate.Candidate;
import io.github.knotresolver.candidate.CandidateQuery;
import io.github.knotresolver.candidate.TrailCandidates;
import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.progress.Progress;
import io.github.knotresolver.track.EndPaths.End;
import io.github.knotresolver.track.EndPaths.EndPath;

/**
 * Finds the clamped end without being told: a free end of the skeleton that moves least
 * over the movie, of an object that is long and moves. It need not stay in one place: a
 * stage may drift or jump. Debris that sticks to the filament has ends that stay, too;
 * among such ends the one wins from which trails explain the skeletons most cheaply.
 */
public final class FixedEndFinder {

	private static final TrailCandidates TRAILS = new TrailCandidates(3, 200, 2,
		TrailCandidates.DEFAULT.prices());

	private final List<FrameView> frames;
	private final Progress progress;

	/**
	 * @param frames the movie
	 * @param progress asked whether to stop
	 */
	public FixedEndFinder(final List<FrameView> frames, final Progress progress) {
		this.frames = frames;
		this.progress = progress;
	}

	/**
	 * An end that was followed.
	 *
	 * @param path where it was seen
	 * @param together votes of the ends that are in the same place as its place in most frames
	 */
	private record Contender(EndPath path, double together) {
	}

	/**
	 * @return the fixed end in pixels, in one of the frames if it moves; empty if no filament
	 *         was found
	 */
	public Optional<Point> find() {
		final List<End> ends = FreeEnds.of(frames);
		final List<EndPath> paths = EndPaths.best(ends, TrackTuning.CONTENDERS, progress);
		if (paths.isEmpty())
			return Optional.empty();
		final double most = paths.get(0).votes();
		final List<Contender> contenders = paths.stream()
			.filter(p -> p.votes() >= TrackTuning.CONTENDER * most).map(FixedEndFinder::contender)
			.toList();
		final double stillest = contenders.stream().mapToDouble(Contender::together).max()
			.orElse(0);
		return contenders.stream()
			.min(Comparator.comparingDouble(c -> price(c.path)
				+ TrackTuning.FEWER_VOTES * (2 - c.path.votes() / most - c.together / stillest)))
			.map(c -> place(c.path));
	}

	private static Contender contender(final EndPath path) {
		double most = 0;
		for (final End end : path.ends())
			most = Math.max(most, together(end, path));
		return new Contender(path, most);
	}

	private static double together(final End end, final EndPath path) {
		return path.ends().stream()
			.filter(e -> e.at().distanceTo(end.at()) <= TrackTuning.SAME_PLACE)
			.mapToDouble(End::vote).sum();
	}

	/** Of all places along a path the one where it is in most frames. */
	private static Point place(final EndPath path) {
		return path.ends().stream().max(Comparator.comparingDouble(e -> together(e, path)))
			.map(End::at).orElseThrow();
	}

	/** Mean price of the best trails from an end, and of its being away from any skeleton, in a sample of frames. */
	private double price(final EndPath path) {
		final AnchorPath anchor = AnchorPath.along(path, frames.size());
		double sum = 0;
		final int tries = Math.min(TrackTuning.FRAMES_TO_TRY, frames.size());
		for (int i = 0; i < tries; i++) {
			progress.checkCancelled();
			final int t = (int) ((i + 0.5) * frames.size() / tries);
			final FrameView frame = frames.get(t);
			final List<Candidate> best = TRAILS
				.generate(CandidateQuery.of(frame.graph(), anchor.at(t), OptionalDouble.empty()),
					progress)
				.candidates();
			sum += best.isEmpty() ? TrackTuning.NO_TRAIL : best.get(0).price().total();
			sum += Math.min(TrackTuning.NO_TRAIL,
				Math.max(0, frame.distance(anchor.at(t)) - TrackTuning.ASIDE));
		}
		return sum / tries;
	}
}
