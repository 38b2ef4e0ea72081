package io.github.knotresolver.track;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.EnumSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.function.IntFunction;
import java.util.stream.IntStream;

import org.apache.commons.math3.stat.descriptive.rank.Median;

import io.github.knotresolver.candidate.CandidateGenerator;
import io.github.knotresolver.candidate.CandidateQuery;
import io.github.knotresolver.candidate.CandidateSet;
import io.github.knotresolver.fit.Bleaching;
import io.github.knotresolver.fit.FilamentEstimate;
import io.github.knotresolver.fit.FilamentEstimator;
import io.github.knotresolver.fit.FilamentEstimator.Sighting;
import io.github.knotresolver.fit.FilamentFitter;
import io.github.knotresolver.fit.Fit;
import io.github.knotresolver.fit.FitSettings;
import io.github.knotresolver.fit.LineModel;
import io.github.knotresolver.fit.NormalizedFrame;
import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.model.Observation;
import io.github.knotresolver.progress.Progress;
import io.github.knotresolver.progress.Workers;

/**
 * Our method: the graph proposes, the fit decides, the trellis settles. Line and
 * length are learned from the clearest frames; hypotheses are carried through the
 * movie in both directions of time, joined in every frame by fits of the graph's
 * candidates; the cheapest path through all fits of all frames is the movie.
 */
public final class FitResolver {

	/** The fixed end that is learned from the clearest frames is this near (pixels), or wrong. */
	private static final double NEAR = 10;

	/** Noise from which on frames are blurred, in strands' brightnesses, and by how much (pixels). */
	private static final double NOISY = 0.3, BLUR = 1;

	/** Number of hypotheses that are carried along. */
	private static final int WIDTH = 3;

	private final CandidateGenerator generator;
	private final Set<LineModel.Kind> kinds;
	private final boolean freeLength;
	private final Workers workers;
	private final Progress progress;

	/**
	 * @param generator proposes contours
	 * @param kinds how strands may add up in this movie, at least one
	 * @param freeLength whether the filament may grow and shrink
	 * @param workers threads
	 * @param progress told how far the work is, and asked whether to stop
	 */
	public FitResolver(final CandidateGenerator generator, final Set<LineModel.Kind> kinds,
		final boolean freeLength, final Workers workers, final Progress progress) {
		this.generator = generator;
		this.kinds = EnumSet.copyOf(kinds);
		this.freeLength = freeLength;
		this.workers = workers;
		this.progress = progress;
	}

	/**
	 * What was found.
	 *
	 * @param estimate line, length and fixed end
	 * @param frames one for each frame asked for, in the same order
	 */
	public record Resolved(FilamentEstimate estimate, List<Observation> frames) {
	}

	/**
	 * Resolves a movie.
	 *
	 * @param frames the frames to resolve, in order of time, at least one
	 * @param fixedEnd the fixed end in pixels, to within a few
	 * @param length the filament's length in pixels; empty to estimate it
	 * @param corrections contours the user gave, by 1-based frame
	 * @return one contour a frame; empty if there is no filament in any
	 */
	public Optional<Resolved> resolve(final List<FrameView> frames, final Point fixedEnd,
		final OptionalDouble length, final Map<Integer, Polyline> corrections) {
		final List<CandidateSet> first = candidates(frames, fixedEnd, OptionalDouble.empty());
		final StrandLight strands = StrandLight.of(frames, first);
		final List<FrameView> steady = withoutBleaching(calmed(frames, strands), strands);
		final List<Sighting> sightings = Sightings.choose(steady, first);
		return sightings.isEmpty()
			? Optional.empty()
			: estimate(sightings, fixedEnd, length)
				.map(e -> resolve(steady, fixedEnd, e, corrections));
	}

	private static List<FrameView> withoutBleaching(final List<FrameView> frames,
		final StrandLight strands) {
		final int first = frames.get(0).frame();
		final double[] brightness = new double[frames.get(frames.size() - 1).frame() - first + 1];
		Arrays.fill(brightness, Double.NaN);
		for (int t = 0; t < frames.size(); t++)
			brightness[frames.get(t).frame() - first] = strands.light()[t];
		final Bleaching learned = Bleaching.learn(brightness);
		// A filament that winds up seems to brighten.
		final Bleaching bleaching = strands.open() || learned.rate() > 0 ? learned : Bleaching.NONE;
		return frames.stream().map(f -> f.scaled(bleaching.factor(f.frame() - first))).toList();
	}

	/** Where single pixels say little, a fit would follow their noise. */
	private List<FrameView> calmed(final List<FrameView> frames, final StrandLight strands) {
		final double[] known = Arrays.stream(strands.light()).filter(l -> l > 0).toArray();
		final double[] noise = workers.map(frames.size(), t -> frames.get(t).light().noise())
			.stream().mapToDouble(Double::doubleValue).toArray();
		return known.length == 0
			|| new Median().evaluate(noise) < NOISY * new Median().evaluate(known)
				? frames
				: workers.map(frames.size(), t -> frames.get(t).blurred(BLUR));
	}

	private Optional<FilamentEstimate> estimate(final List<Sighting> sightings,
		final Point fixedEnd, final OptionalDouble length) {
		progress.report("Learning what the filament looks like", 0);
		return FilamentEstimator.estimate(sightings, kinds, workers, progress)
			.map(e -> length.isPresent() ? e.withLength(length.getAsDouble()) : e)
			.map(e -> e.fixedEnd().distanceTo(fixedEnd) > NEAR ? e.withFixedEnd(fixedEnd) : e);
	}

	private Resolved resolve(final List<FrameView> frames, final Point fixedEnd,
		final FilamentEstimate estimate, final Map<Integer, Polyline> corrections) {
		final List<CandidateSet> sets = candidates(frames, fixedEnd,
			freeLength ? OptionalDouble.empty() : OptionalDouble.of(estimate.length()));
		final List<NormalizedFrame> light = frames.stream()
			.map(f -> f.light().rescaled(0, estimate.amplitude())).toList();
		final List<List<Fit>> pools = pools(frames, light, estimate, sets, corrections);
		return new Resolved(estimate,
			new FitTrellis(frames, light, estimate, pools, sets).solve(corrections, progress));
	}

	private List<CandidateSet> candidates(final List<FrameView> frames, final Point fixedEnd,
		final OptionalDouble length) {
		return workers.map("Proposing contours", progress, frames.size(), t -> generator
			.generate(CandidateQuery.of(frames.get(t).graph(), fixedEnd, length), progress));
	}

	private List<List<Fit>> pools(final List<FrameView> frames, final List<NormalizedFrame> light,
		final FilamentEstimate estimate, final List<CandidateSet> sets,
		final Map<Integer, Polyline> corrections) {
		final int n = frames.size();
		final FitSettings settings = FitSettings.DEFAULT.withFreeLength(freeLength);
		final IntFunction<FilamentFitter> fitters = t -> fitter(light.get(t), estimate, settings);
		final FitSettings rough = settings.roughAndStiff(FitProposals.START_STIFFNESS);
		final FitProposals proposer = new FitProposals(estimate, freeLength);
		final List<List<Fit>> proposals = workers.map("Fitting the proposals", progress, n, t -> {
			final Polyline given = corrections.get(frames.get(t).frame());
			return given == null
				? proposer.of(sets.get(t), fitters.apply(t), fitter(light.get(t), estimate, rough))
				: proposer.of(given, fitters.apply(t));
		});
		final Propagation propagation = new Propagation(WIDTH, MotionPrice.learn(proposals),
			fitters, proposals, t -> corrections.containsKey(frames.get(t).frame()), progress);
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

	private static FilamentFitter fitter(final NormalizedFrame light,
		final FilamentEstimate estimate, final FitSettings settings) {
		return new FilamentFitter(light, estimate.model(),
			FilamentEstimator.links(estimate.length()), Optional.of(estimate.fixedEnd()), settings);
	}
}
