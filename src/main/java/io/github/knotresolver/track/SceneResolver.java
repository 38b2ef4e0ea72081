
package io.github.knotresolver.track;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.Set;

import io.github.knotresolver.fit.Chain;
import io.github.knotresolver.fit.LineModel;
import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.model.AnchorChoice;
import io.github.knotresolver.progress.Progress;
import io.github.knotresolver.progress.Workers;
import io.github.knotresolver.track.SceneSettler.Settled;

/**
 * Resolves a movie with several filaments, clamped or free: seeds in some frames, from which
 * all filaments are followed together through the movie, forwards and backwards; what
 * several such passes say is settled for each filament. How many filaments there are is told
 * by the whole movie: of two passes the one is right that leaves less light unexplained.
 */
public final class SceneResolver {

	/** At most so many passes are tried, and of those so many are settled. */
	private static final int MOST_PASSES = 5, SETTLED = 3;

	/** A pass that leaves less than this (strands squared a frame and filament) is right. */
	private static final double CLEAR = 0.05;

	private final Set<LineModel.Kind> kinds;
	private final Workers workers;
	private final Progress progress;

	/**
	 * @param kinds how strands may add up in this movie, at least one
	 * @param workers threads
	 * @param progress told how far the work is, and asked whether to stop
	 */
	public SceneResolver(final Set<LineModel.Kind> kinds, final Workers workers,
		final Progress progress) {
		this.kinds = Set.copyOf(kinds);
		this.workers = workers;
		this.progress = progress;
	}

	/**
	 * Resolves a movie. Linear in frames and filaments, but for those that touch.
	 *
	 * @param frames the frames to resolve, in order of time, at least one
	 * @param anchor whether filaments are held at one end
	 * @return all filaments; empty if there is none
	 */
	public Optional<SceneTracks> resolve(final List<FrameView> frames, final AnchorChoice anchor) {
		return solve(frames).map(s -> SceneTracks.of(s.line, s.filaments, anchor));
	}

	/**
	 * The movie without the light of all filaments but one.
	 *
	 * @param frames the frames, in order of time, at least one
	 * @param end where one end of that filament is, in pixels
	 * @return the frames, the light in strands; as they are if no filament ends there
	 */
	public List<FrameView> alone(final List<FrameView> frames, final Point end) {
		return solve(frames).map(s -> {
			final ScenePass pass = ScenePass.of(s.filaments);
			final int k = pass.endingAt(end);
			return k < 0 ? frames : new ClampedAgain(s.line, workers, progress).alone(pass, k);
		}).orElse(frames);
	}

	private record Solved(SceneLine line, List<Settled> filaments) {
	}

	private Optional<Solved> solve(final List<FrameView> frames) {
		if (frames.stream().allMatch(f -> f.graph().segments().isEmpty()))
			return Optional.empty();
		progress.report("Learning what a filament looks like", 0);
		final SceneLine line = SceneLine.learn(frames, kinds, workers, progress);
		final SceneWeights weights = SceneWeights.DEFAULT;
		final List<SceneSeed> seeds = new SceneSeeds(line, weights).all(workers, progress);
		final List<Priced> passes = passes(line, weights, seeds);
		return passes.isEmpty()
			? Optional.empty()
			: Optional.of(new Solved(line, new SceneRefinement(line, weights, workers, progress)
				.refine(settled(line, weights, passes))));
	}

	/** A pass with its price, and what of it is unexplained light. */
	private record Priced(ScenePass pass, double price) {
		double unexplained() {
			return price - pass.priceOfFilaments();
		}

		boolean isClear() {
			return unexplained() < CLEAR * pass.filaments();
		}
	}

	/** Passes from the best seeds, until one explains everything; the cheapest first. */
	private List<Priced> passes(final SceneLine line, final SceneWeights weights,
		final List<SceneSeed> seeds) {
		final List<Priced> passes = new ArrayList<>();
		for (final SceneSeed seed : SceneSeeds.chosen(seeds, MOST_PASSES, line.frames().size())) {
			progress.report("Following the filaments", (double) passes.size() / MOST_PASSES);
			if (seed.chains().isEmpty())
				continue;
			final ScenePass pass = ScenePass.from(seed.frame(), seed.chains(), line, weights,
				progress);
			passes.add(new Priced(pass, pass.price(line)));
			for (int t = 0; t < line.frames().size(); t++)
				progress.sighted(line.frames().get(t).frame(),
					pass.chains().get(t).stream().map(Chain::contour).toList());
			if (passes.get(passes.size() - 1).isClear())
				break;
		}
		passes.sort(Comparator.comparingDouble(Priced::price));
		return passes;
	}

	/** The settled movie, or the best pass alone where that explains more. */
	private List<Settled> settled(final SceneLine line, final SceneWeights weights,
		final List<Priced> passes) {
		final List<ScenePass> best = passes.stream().limit(passes.get(0).isClear() ? 1 : SETTLED)
			.map(Priced::pass).toList();
		final SceneSettler settler = new SceneSettler(line, weights, best);
		final List<Settled> settled = settler.settle(progress);
		return ScenePass.of(settled).price(line) <= passes.get(0).price()
			? settled
			: settler.first(settled);
	}
}
