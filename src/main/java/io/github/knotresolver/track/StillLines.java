package io.github.knotresolver.track;

import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import java.util.stream.IntStream;

import io.github.knotresolver.fit.Chain;
import io.github.knotresolver.fit.LineModel;
import io.github.knotresolver.fit.NormalizedFrame;
import io.github.knotresolver.fit.Scene;
import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.graph.Node;
import io.github.knotresolver.graph.SkeletonGraph;
import io.github.knotresolver.image.LineAppearance;
import io.github.knotresolver.image.Pixels;
import io.github.knotresolver.image.StillPicture;
import io.github.knotresolver.progress.Progress;
import io.github.knotresolver.progress.Workers;
import io.github.knotresolver.skeleton.Skeletonize;

/**
 * Whole lines that lie still in a movie while something moves over them: both ends are free ends
 * in the same place in nearly all frames, and the darkest frames of each pixel between them are
 * as bright as a strand. Where light adds up, as it is seen to do where they are passed, theirs
 * can be taken off: what is left shows the filaments that move as if they were alone. A part of
 * a filament that lies still is no such line, since the filament goes on beyond it.
 */
public final class StillLines {

	private static final SceneWeights STIFF = new SceneWeights(SceneTuning.STILL_STIFFNESS);

	private final List<FrameView> frames;
	private final Workers workers;
	private final Progress progress;

	private StillLines(final List<FrameView> frames, final Workers workers,
		final Progress progress) {
		this.frames = frames;
		this.workers = workers;
		this.progress = progress;
	}

	/**
	 * A movie in two parts.
	 *
	 * @param rest the frames without the light of lines that lie still
	 * @param lines these lines, the longest first; free, in no particular direction
	 */
	public record Found(List<FrameView> rest, List<SceneTracks.Filament> lines) {
	}

	/**
	 * O(pixels of 32 frames); where no two ends lie still, O(ends) only.
	 *
	 * @param frames a movie, in order of time
	 * @param kinds how strands may add up
	 * @param meant ends of filaments that are asked for; lines that end there are left in
	 * @param workers threads
	 * @param progress asked whether to stop
	 * @return the movie and no lines if none lies still, or their light does not add up
	 */
	public static Found in(final List<FrameView> frames, final Collection<LineModel.Kind> kinds,
		final List<Point> meant, final Workers workers, final Progress progress) {
		final List<StillLine> lines = frames.size() < SceneTuning.STILL_LEAST
			|| !kinds.contains(LineModel.Kind.ADDITIVE)
			|| frames.stream().anyMatch(f -> f.light().isClipped())
				? List.of()
				: new StillLines(frames, workers, progress).lines(meant);
		List<FrameView> rest = frames;
		for (final StillLine line : lines) {
			final List<FrameView> before = rest;
			rest = workers.map(rest.size(), t -> line.takenOff(before.get(t)));
		}
		return new Found(rest, lines.stream().map(l -> l.filament(frames)).toList());
	}

	private List<StillLine> lines(final List<Point> meant) {
		final List<Point> ends = stillEnds();
		if (ends.size() < 2)
			return List.of();
		final double strand = SceneLine.firstStrand(frames);
		final FrameView still = picture(strand);
		if (still.graph().segments().isEmpty())
			return List.of();
		final SceneLine line = SceneLine.learn(List.of(still), Set.of(LineModel.Kind.ADDITIVE),
			Workers.HERE, progress);
		final double shortest = line.shortestFilament();
		return chains(line, c -> c.length() >= shortest && isBetween(c, ends) && !endsIn(c, meant))
			.stream().filter(c -> isBetween(c, ends))
			.map(c -> StillLine.of(c, line.tables(), still.light(), frames))
			.filter(l -> isStill(l, strand))
			.sorted((a, b) -> Double.compare(b.chain().length(), a.chain().length())).toList();
	}

	/**
	 * The chains of the still picture that may be lines, beside the others. Where a filament runs
	 * into a line and out of it, they may have exchanged their parts; by itself, straight where it can
	 * be, and stiff, the line goes on as it came. Then the others follow.
	 */
	private static List<Chain> chains(final SceneLine still, final Predicate<Chain> mayBe) {
		final List<Chain> found = new SceneSeeder(still.tables(), SceneWeights.DEFAULT)
			.chains(still.frames().get(0), List.of());
		final Set<Integer> lines = IntStream.range(0, found.size())
			.filter(k -> mayBe.test(found.get(k))).boxed()
			.collect(Collectors.toCollection(TreeSet::new));
		final Scene scene = still.scene(0, found);
		for (int k = 0; k < found.size(); k++)
			scene.take(k);
		for (final int k : lines) {
			scene.put(k, straight(still, found.get(k)));
			fit(scene, k, STIFF);
		}
		for (int sweep = 0; sweep < SceneTuning.STILL_SWEEPS; sweep++)
			for (int k = 0; k < found.size(); k++)
				fit(scene, k, lines.contains(k) ? STIFF : SceneWeights.DEFAULT);
		return lines.stream().map(scene::chain).toList();
	}

	private static Chain straight(final SceneLine still, final Chain line) {
		final Polyline way = new StraightWay(still.frames().get(0).light(),
			LineAppearance.FULL_WIDTH * still.tables().model().sigma(), SceneTuning.STILL_BRIGHT)
			.of(line.polyline());
		return Chain.inScene(way, way.length());
	}

	private static void fit(final Scene scene, final int k, final SceneWeights weights) {
		final Chain start = scene.chain(k);
		scene.take(k);
		scene.put(k,
			scene.window(List.of(start)).fit(start, Optional.empty(), weights.free()).chain());
	}

	private boolean isStill(final StillLine line, final double strand) {
		final List<Integer> there = workers.map(frames.size(),
			t -> !line.isIn(frames.get(t)) ? 0 : line.isPassed(frames.get(t), strand) ? 2 : 1);
		return there.stream().filter(f -> f > 0).count() >= SceneTuning.STILL_THERE * there.size()
			&& there.stream().filter(f -> f > 1).count() >= SceneTuning.CROSSINGS_FEWEST;
	}

	/** Where free ends are in the same place in nearly all frames, each place once. */
	private List<Point> stillEnds() {
		final List<List<Point>> ends = frames.stream()
			.map(f -> f.graph().freeEnds().stream().map(Node::position).toList()).toList();
		final List<Point> still = new ArrayList<>();
		for (final int t : StillPicture.looks(ends.size(), SceneTuning.STILL_END_LOOKS))
			for (final Point end : ends.get(t))
				if (!isNear(end, still) && ends.stream().filter(e -> isNear(end, e))
					.count() >= SceneTuning.STILL_END_SEEN * ends.size())
					still.add(end);
		return still;
	}

	private static boolean isNear(final Point end, final List<Point> others) {
		return others.stream().anyMatch(o -> o.distanceTo(end) <= SceneTuning.STILL_END_NEAR);
	}

	private static boolean isBetween(final Chain chain, final List<Point> ends) {
		return isNear(chain.start(), ends) && isNear(chain.polyline().last(), ends);
	}

	private static boolean endsIn(final Chain chain, final List<Point> places) {
		return places.stream().anyMatch(p -> Math.min(p.distanceTo(chain.start()),
			p.distanceTo(chain.polyline().last())) <= SceneTuning.PLACE_NEAR);
	}

	/** What stays where it is, as a frame. */
	private FrameView picture(final double strand) {
		final int[] looks = StillPicture.looks(frames.size(), SceneTuning.STILL_LOOKS);
		final List<float[]> some = workers.map(looks.length,
			k -> Pixels.floats(frames.get(looks[k]).light().pixels()));
		final NormalizedFrame first = frames.get(0).light();
		final NormalizedFrame still = NormalizedFrame.of(first.width(), first.height(),
			StillPicture.of(some));
		final double bright = SceneTuning.STILL_BRIGHT * SceneTuning.MEAN_OF_RIDGE * strand;
		final boolean[] mask = new boolean[still.width() * still.height()];
		IntStream.range(0, mask.length).forEach(
			i -> mask[i] = still.meanAround(i % still.width(), i / still.width()) > bright);
		final var masked = Pixels.mask(mask, still.width());
		return new FrameView(1, still, masked, SkeletonGraph.of(Skeletonize.thin(masked)));
	}
}
