
package io.github.knotresolver.track;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;

import io.github.knotresolver.fit.Chain;
import io.github.knotresolver.fit.LineModel;
import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.model.Observation;
import io.github.knotresolver.model.Settings.AnchorChoice;
import io.github.knotresolver.progress.Progress;
import io.github.knotresolver.progress.Workers;
import io.github.knotresolver.track.SceneLengths.Length;
import io.github.knotresolver.track.SceneSettler.Settled;

/**
 * Resolves a movie with several filaments, clamped or free: seeds in some frames, from which
 * all filaments are followed together through the movie, forwards and backwards; what
 * several such passes say is settled for each filament. How many filaments there are is told
 * by the whole movie: of two passes the one is right that leaves less light unexplained.
 */
public final class SceneResolver {

	private final List<FrameView> frames;
	private final Set<LineModel.Kind> kinds;
	private final Workers workers;
	private final Progress progress;
	/** What lines look like, once it is learned. */
	private Optional<SceneLine> learned = Optional.empty();
	/** All filaments, one or many, once they were followed. */
	private Optional<Solved> followed = Optional.empty();

	/**
	 * @param frames the frames to resolve, in order of time, at least one
	 * @param kinds how strands may add up in this movie, at least one
	 * @param workers threads
	 * @param progress told how far the work is, and asked whether to stop
	 */
	public SceneResolver(final List<FrameView> frames, final Set<LineModel.Kind> kinds,
		final Workers workers, final Progress progress) {
		this.frames = frames;
		this.kinds = Set.copyOf(kinds);
		this.workers = workers;
		this.progress = progress;
	}

	/**
	 * Resolves a movie. Linear in frames and filaments, but for those that touch.
	 *
	 * @param anchor whether filaments are held at one end
	 * @return all filaments; empty if there is none, or clearly only one that is clamped, for which
	 *         there are better means
	 */
	public Optional<SceneTracks> resolve(final AnchorChoice anchor) {
		return solve(anchor != AnchorChoice.FREE).map(s -> tracks(s, anchor));
	}

	/**
	 * The filament under a point, if it is free: then it is followed as one of all filaments.
	 *
	 * @param place in pixels
	 * @param anchor whether filaments are held at one end
	 * @return that filament; empty if a held one ends there, or no filament lies there that is
	 *         free
	 */
	public Optional<SceneTracks> freeUnder(final Point place, final AnchorChoice anchor) {
		return all().flatMap(s -> tracks(s, anchor).freeUnder(place));
	}

	private SceneTracks tracks(final Solved solved, final AnchorChoice anchor) {
		final SceneLine line = solved.line;
		final boolean[][] clear = ScenePass.of(solved.filaments).clear(line, workers);
		final List<Length> lengths = lengths(solved, clear);
		return new ExchangedHalves(line, solved.weights, workers, progress)
			.mended(solved.filaments, lengths).map(m -> {
				final Solved mended = new Solved(line, solved.weights, m);
				final boolean[][] again = ScenePass.of(m).clear(line, workers);
				return SceneTracks.of(line, measured(m, lengths(mended, again)), again, anchor);
			}).orElseGet(
				() -> SceneTracks.of(line, measured(solved.filaments, lengths), clear, anchor));
	}

	/** All filaments, also if there is but one that is clamped. */
	private Optional<Solved> all() {
		if (followed.isEmpty())
			followed = solve(false);
		return followed;
	}

	/**
	 * The movie without the light of all filaments but one.
	 *
	 * @param end where one end of that filament is, in pixels
	 * @return the frames, the light in strands; as they are if no filament ends there
	 */
	public List<FrameView> alone(final Point end) {
		return all().map(s -> {
			final ScenePass pass = ScenePass.of(s.filaments);
			final int k = pass.endingAt(end);
			return k < 0 ? frames : new ClampedAgain(s.line, workers, progress).alone(pass, k);
		}).orElse(frames);
	}

	/**
	 * Whether the movie shows one clamped filament or several, where its graphs leave that open: the
	 * one explanation is right that leaves less light. O(pixels of the movie).
	 *
	 * @param one one clamped filament in each frame
	 * @param many several
	 * @return whether one explains the movie no worse
	 */
	public boolean isOne(final List<Observation> one, final SceneTracks many) {
		return price(contours(List.of(one)), 1) <= price(
			contours(many.filaments().stream().map(SceneTracks.Filament::frames).toList()),
			many.filaments().size());
	}

	/** For each frame all contours that are known. */
	private List<List<Polyline>> contours(final List<List<Observation>> filaments) {
		final Map<Integer, List<Polyline>> byFrame = filaments.stream().flatMap(List::stream)
			.filter(o -> o.contour().isPresent()).collect(Collectors.groupingBy(Observation::frame,
				Collectors.mapping(o -> o.contour().orElseThrow(), Collectors.toList())));
		return frames.stream().map(f -> byFrame.getOrDefault(f.frame(), List.of())).toList();
	}

	/**
	 * The price of an explanation: light that is left or too much, in strands squared, mean over the
	 * frames, and a price for each filament.
	 *
	 * @param contours for each frame its filaments' contours in pixels; those that are not known
	 *          are missing
	 */
	double price(final List<List<Polyline>> contours, final int filaments) {
		final SceneLine line = line();
		return workers
			.map(contours.size(),
				t -> line.left(t,
					contours.get(t).stream().filter(c -> c.length() > 0)
						.map(c -> Chain.inScene(c, c.length())).toList()))
			.stream().mapToDouble(Double::doubleValue).average().orElse(0)
			+ SceneTuning.PER_FILAMENT * filaments;
	}

	private SceneLine line() {
		if (learned.isEmpty())
			learned = Optional.of(SceneLine.learn(frames, kinds, workers, progress));
		return learned.get();
	}

	private record Solved(SceneLine line, SceneWeights weights, List<Settled> filaments) {
	}

	/**
	 * @param onlyScenes whether one clamped filament, as soon as it is known to be that, is left
	 *          alone: following it, and what is made for it, takes longer than all else
	 */
	private Optional<Solved> solve(final boolean onlyScenes) {
		if (frames.stream().allMatch(f -> f.graph().segments().isEmpty()))
			return Optional.empty();
		progress.report("Learning what a filament looks like", 0);
		final SceneLine line = line();
		final SceneWeights weights = SceneWeights.DEFAULT;
		final SceneSeeds looks = new SceneSeeds(line, weights);
		final List<PricedPass> passes = passes(line, weights, looks, looks.all(workers, progress));
		if (passes.isEmpty())
			return Optional.empty();
		final List<Settled> followed = new TailExchanges(line, weights, workers, progress)
			.checked(new JoinedPieces(line, weights, workers, progress)
				.joined(settled(line, weights, passes)));
		if (onlyScenes && isOneClamped(line, followed))
			return Optional.empty();
		return Optional.of(new Solved(line, weights,
			new SceneRefinement(line, weights, workers, progress).refine(followed)));
	}

	/** Whether refinement can but make the only filament better, or a speck longer. */
	private boolean isOneClamped(final SceneLine line, final List<Settled> followed) {
		final double speck = line.shortestFilament();
		if (followed.stream().filter(f -> f.chains().get(0).length() >= speck).count() != 1)
			return false;
		final boolean[][] clear = ScenePass.of(followed).clear(line, workers);
		final SceneTracks tracks = SceneTracks.of(line, followed, clear, AnchorChoice.AUTO);
		return tracks.isOneClamped() && (tracks.filaments().get(0).clamped() || !isCredible(clear));
	}

	/** Whether little is left to be made better of what was followed. */
	private static boolean isCredible(final boolean[][] clear) {
		int frames = 0;
		for (int t = 0; t < clear[0].length; t++) {
			boolean all = true;
			for (final boolean[] c : clear)
				all &= c[t];
			frames += all ? 1 : 0;
		}
		return frames >= SceneTuning.CREDIBLE * clear[0].length;
	}

	/**
	 * Passes from the best seeds, until one explains everything; the cheapest first. What a
	 * pass confirms is known when the next seed is looked for.
	 */
	private List<PricedPass> passes(final SceneLine line, final SceneWeights weights,
		final SceneSeeds looks, final List<SceneSeed> first) {
		final List<PricedPass> passes = new ArrayList<>();
		final List<SceneSeed> used = new ArrayList<>();
		final ScenePool pool = new ScenePool(line);
		Optional<SceneSeed> seed = first.stream().findFirst();
		while (seed.isPresent() && used.size() < SceneTuning.MOST_PASSES) {
			progress.report("Following the filaments",
				(double) passes.size() / SceneTuning.MOST_PASSES);
			used.add(seed.get());
			if (!seed.get().chains().isEmpty()) {
				final ScenePass pass = followed(seed.get(), line, weights);
				final PricedPass priced = PricedPass.of(pass, line, workers);
				passes.add(priced);
				show(pass, line);
				final boolean allClear = pool.add(priced);
				if (priced.isClear() && (allClear || used.size() >= SceneTuning.CLEAR_ENOUGH))
					break;
			}
			seed = looks.next(first, used, pool, workers, progress);
		}
		PricedPass.sort(passes);
		withBetterLengths(line, weights, passes);
		return passes;
	}

	/** Where light does not add up, what is left beside crossings does not tell how a seed is mended. */
	private ScenePass followed(final SceneSeed seed, final SceneLine line,
		final SceneWeights weights) {
		return line.tables().model().kind() == LineModel.Kind.ADDITIVE
			? new MendedSeed(line, weights, workers, progress, seed.frame()).followed(seed.chains())
			: ScenePass.from(seed.frame(), seed.chains(), line, weights, workers, progress);
	}

	private void show(final ScenePass pass, final SceneLine line) {
		for (int t = 0; t < line.frames().size(); t++)
			progress.sighted(line.frames().get(t).frame(),
				pass.chains().get(t).stream().map(Chain::contour).toList());
	}

	/** The best pass once more, with halves exchanged that were, and the lengths that it tells. */
	private void withBetterLengths(final SceneLine line, final SceneWeights weights,
		final List<PricedPass> passes) {
		if (passes.isEmpty())
			return;
		final PricedPass first = passes.get(0);
		final PricedPass best = new ExchangedSeed(line, weights, workers, progress).mended(first);
		final ScenePass pass = best.pass();
		if (best != first)
			passes.add(best);
		new SceneLengths(line, weights).corrected(best, workers)
			.or(() -> Optional.of(pass.chains().get(pass.start())).filter(c -> best != first))
			.map(chains -> ScenePass.from(pass.start(), chains, line, weights, workers, progress))
			.ifPresent(again -> passes.add(PricedPass.of(again, line, workers)));
		PricedPass.sort(passes);
	}

	private List<Length> lengths(final Solved solved, final boolean[][] clear) {
		return new SceneLengths(solved.line, solved.weights).of(ScenePass.of(solved.filaments),
			clear, workers);
	}

	/** The filaments with standard errors of their lengths, in doubt where a length changes. */
	private static List<Settled> measured(final List<Settled> filaments,
		final List<Length> lengths) {
		final List<Settled> measured = new ArrayList<>();
		for (int k = 0; k < lengths.size(); k++) {
			final Settled f = filaments.get(k);
			final double error = lengths.get(k).error();
			final double[] gap = lengths.get(k).step().isPresent() ? inDoubt(f.gap()) : f.gap();
			measured.add(
				new Settled(f.chains(), gap, Double.isFinite(error) ? error : f.lengthError()));
		}
		return measured;
	}

	private static double[] inDoubt(final double[] gap) {
		final double most = SceneConfidence.gapOf(SceneTuning.LENGTH_DOUBT);
		return Arrays.stream(gap).map(g -> Math.min(g, most)).toArray();
	}

	/** The settled movie if it explains visibly more than the best pass; otherwise that. */
	private List<Settled> settled(final SceneLine line, final SceneWeights weights,
		final List<PricedPass> passes) {
		final PricedPass best = passes.get(0);
		final List<ScenePass> some = PricedPass.together(passes).stream().map(PricedPass::pass)
			.toList();
		final SceneSettler settler = new SceneSettler(line, weights, some);
		final List<Settled> settled = settler.settle(progress);
		if (some.size() == 1)
			return settled;
		final ScenePass together = ScenePass.of(settled);
		return together.price(line, workers)
			- together.priceOfFilaments() <= SceneTuning.VISIBLY_LESS * best.unexplained()
				? settled
				: settler.first(settled);
	}
}
