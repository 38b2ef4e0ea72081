package io.github.knotresolver.track;

import java.util.Arrays;
import java.util.EnumSet;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;

import org.apache.commons.math3.stat.descriptive.rank.Median;

import io.github.knotresolver.candidate.CandidateSet;
import io.github.knotresolver.fit.FilamentEstimate;
import io.github.knotresolver.fit.FilamentEstimator;
import io.github.knotresolver.fit.FilamentEstimator.Sighting;
import io.github.knotresolver.fit.FitSettings;
import io.github.knotresolver.fit.LineModel;
import io.github.knotresolver.fit.NormalizedFrame;
import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.graph.GraphTuning;
import io.github.knotresolver.model.Settings.LengthModel;
import io.github.knotresolver.progress.Progress;
import io.github.knotresolver.progress.Workers;

/**
 * Finds out what the filament of a movie is like: what its line looks like, how long it is, and
 * where its fixed end is; from skeletons, and once more from the contours of the solved movie
 * where skeletons are not to be trusted.
 *
 * @param kinds how strands may add up in this movie, at least one
 * @param lengths whether the filament may grow and shrink
 * @param workers threads
 * @param progress told how far the work is, and asked whether to stop
 */
record FilamentLearner(Set<LineModel.Kind> kinds, LengthModel lengths, Workers workers,
	Progress progress) {

	/**
	 * What is known before the line is.
	 *
	 * @param frames without bleaching and noise
	 * @param sets the graph's proposals, as long as no length is known
	 * @param ends the skeletons' ends near the fixed end
	 * @param told the length in pixels, if it was
	 * @param endsFree weights of a fit with both ends and the length free
	 */
	record Look(List<FrameView> frames, List<CandidateSet> sets, AnchorPath ends,
		OptionalDouble told, FitSettings endsFree) {

		/** Whether noise drowned single pixels. */
		boolean isNoisy() {
			return endsFree.isNoisy();
		}
	}

	/**
	 * What the frames tell of the filament.
	 *
	 * @param endIsDoubtful whether little says that its fixed end moves, or stays
	 */
	record Seen(Look look, FilamentCourse course, boolean endIsDoubtful) {

		List<FrameView> frames() {
			return look.frames;
		}

		Seen withNoise(final double noise) {
			return new Seen(look, course.withNoise(noise), endIsDoubtful);
		}

		/** The same filament with another line, as long in all frames. */
		Seen withEstimate(final FilamentEstimate other) {
			return withCourse(course.withEstimate(other)
				.withLength(LengthCourse.constant(other.length(), look.frames.size())));
		}

		Seen withCourse(final FilamentCourse other) {
			return new Seen(look, other, endIsDoubtful);
		}

		/** The same, if the fixed end stays where the clearest frames have it. */
		FilamentCourse still() {
			return course
				.withAnchor(AnchorPath.still(course.estimate().fixedEnd(), look.frames.size()));
		}
	}

	/**
	 * Learns from the clearest frames.
	 *
	 * @param frames the movie, in order of time, at least one
	 * @param first the graph's proposals, as long as no length is known
	 * @param ends the skeletons' ends near the fixed end
	 * @param fixedEnd in pixels, to within a few
	 * @param length in pixels, if it is known
	 * @return what they say; empty if no frame shows a filament
	 */
	Optional<Seen> look(final List<FrameView> frames, final List<CandidateSet> first,
		final AnchorPath ends, final Point fixedEnd, final OptionalDouble length) {
		final List<FrameView> focused = Focus.known(frames, first);
		final StrandLight strands = StrandLight.of(focused, first);
		final List<FrameView> calmed = calmed(focused, strands);
		// Where focus wanders, every frame has been brought to the same brightness.
		final List<FrameView> steady = focused == frames
			? strands.withoutBleaching(calmed)
			: calmed;
		final double noise = Calming.noise(focused, workers);
		final FitSettings free = calmed == focused
			? FitSettings.ENDS_FREE
			: FitSettings.ENDS_FREE.withStiffness(FitSettings.NOISY_STIFFNESS);
		final List<Sighting> sightings = Sightings.choose(steady, first);
		if (sightings.isEmpty())
			return Optional.empty();
		final Optional<FilamentEstimate> bent = estimate(sightings, fixedEnd, length, free);
		// How strong the noise is beside a strand is known when the strand is, not where it was cut off.
		final FitSettings endsFree = calmed == focused && bent.isPresent()
			&& !isCutOff(sightings, bent.get())
				? free.inNoise(noise / bent.get().amplitude(), TrackTuning.NOISY)
				: free;
		return (endsFree.equals(free) ? bent : estimate(sightings, fixedEnd, length, endsFree))
			.map(e -> seen(new Look(steady, first, ends, length, endsFree), e)
				.withNoise(noise / e.amplitude()));
	}

	/** Whether a strand may be brighter than it is seen, so that noise is less of it than it seems. */
	private static boolean isCutOff(final List<Sighting> sightings,
		final FilamentEstimate estimate) {
		return estimate.model().kind() != LineModel.Kind.ADDITIVE && areClipped(sightings);
	}

	private static boolean areClipped(final List<Sighting> sightings) {
		return sightings.stream().anyMatch(s -> s.frame().isClipped());
	}

	/** Looks at the open frames to see whether the fixed end moves and the length changes. */
	private Seen seen(final Look look, final FilamentEstimate estimate) {
		final OpenFrames open = OpenFrames.find(look.frames, light(look.frames, estimate),
			look.sets, estimate, look.endsFree, workers, progress);
		final AnchorPath anchor = look.ends.settled(open, estimate.fixedEnd());
		final int frames = look.frames.size();
		final Lengths length = Lengths.of(open, frames,
			look.told.isEmpty() && lengths == LengthModel.AUTO && !estimate.guessed());
		final FilamentEstimate settled = look.told.isPresent() ? estimate : length.settle(estimate);
		return new Seen(look, new FilamentCourse(settled, anchor,
			length.course(settled.length(), frames), 0, look.endsFree.stiffness()),
			anchor.isDoubtful(open) || look.isNoisy());
	}

	/** The frames' pixels, a strand's brightness 1. */
	static List<NormalizedFrame> light(final List<FrameView> frames,
		final FilamentEstimate estimate) {
		return frames.stream().map(f -> f.light().rescaled(0, estimate.amplitude())).toList();
	}

	private List<FrameView> calmed(final List<FrameView> frames, final StrandLight strands) {
		final double[] known = Arrays.stream(strands.light()).filter(l -> l > 0).toArray();
		return known.length == 0
			? frames
			: Calming.of(frames, new Median().evaluate(known), workers);
	}

	private Optional<FilamentEstimate> estimate(final List<Sighting> sightings,
		final Point fixedEnd, final OptionalDouble length, final FitSettings endsFree) {
		progress.report("Learning what the filament looks like", 0);
		// Of what was cut off it is known where: lines that add up can be told, too.
		final Set<LineModel.Kind> possible = areClipped(sightings) ? LineModel.UNCLIPPED : kinds;
		return FilamentEstimator.estimate(sightings, possible, endsFree, workers, progress)
			.map(e -> length.isPresent() ? e.withLength(length.getAsDouble()) : e)
			.map(e -> e.fixedEnd().distanceTo(fixedEnd) > GraphTuning.NEAR_CLAMP
				? e.withFixedEnd(fixedEnd)
				: e);
	}

	/**
	 * In noise skeletons end anywhere, so that what was learned from them of the line and its ends
	 * may be wrong; and where the filament has a dim end, how bright that is and where it is
	 * are learned together, which takes more frames than are clearest. The movie's contours know it
	 * better.
	 *
	 * @param seen what was learned from skeletons
	 * @param first who answers with that
	 * @return what the contours say; empty if that is no other length or fixed end
	 */
	Optional<Seen> again(final Seen seen, final FitSolver first) {
		final FilamentEstimate known = seen.course.estimate();
		final boolean noisy = seen.look.isNoisy();
		if (!noisy && (!known.model().hasDimEnd()
			|| seen.course.length().kind() != LengthCourse.Kind.CONSTANT))
			return Optional.empty();
		final List<Sighting> sightings = Sightings.solved(seen.frames(), first.solved(progress),
			known.model(), noisy ? TrackTuning.SIGHTINGS : TrackTuning.UNEVEN_SIGHTINGS);
		if (sightings.isEmpty())
			return Optional.empty();
		// A length that was a guess remains one.
		return FilamentEstimator
			.estimate(
				sightings, EnumSet.of(known.model().kind()), seen.look.endsFree, workers, progress)
			.map(e -> noisy ? e : e.inUnitsOf(known.amplitude()))
			.map(e -> !noisy && isSame(e, known)
				? e.withGuessed(known.guessed())
				: e.orGuessed(known.guessed()))
			.filter(first::isOtherThan).map(e -> (noisy ? seen(seen.look, e) : seen.withEstimate(e))
				.withNoise(seen.course.noiseOf(e)));
	}

	/** Whether more frames show the same ends, which need not settle once more then. */
	private static boolean isSame(final FilamentEstimate other, final FilamentEstimate known) {
		return Math.abs(other.length() / known.length() - 1) < TrackTuning.SAME_ENDS;
	}
}
