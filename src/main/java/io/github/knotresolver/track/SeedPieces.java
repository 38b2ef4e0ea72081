
package io.github.knotresolver.track;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;

import io.github.knotresolver.fit.Chain;
import io.github.knotresolver.fit.Scene;
import io.github.knotresolver.geometry.Polyline;

/** What else filaments of a frame might be: two that lie end to end, or each other's halves. */
final class SeedPieces {

	private final SceneLine line;
	private final SceneWeights weights;
	private final int start;

	/** Some filaments of a frame, what there is instead, and what all leave then. */
	record Other(List<Integer> of, List<Chain> instead, double price) {
	}

	/** @param start index of the frame */
	SeedPieces(final SceneLine line, final SceneWeights weights, final int start) {
		this.line = line;
		this.weights = weights;
		this.start = start;
	}

	/**
	 * A filament cut in two where it turns most, and where it is darkest when it is followed.
	 *
	 * @param seed all filaments of the frame
	 * @param first the first frame in which it was followed
	 * @param followed the filament in that frame and the next ones
	 */
	List<Other> cuts(final List<Chain> seed, final int k, final int first,
		final List<Chain> followed) {
		final Polyline curve = seed.get(k).polyline().resampled(1);
		final List<Integer> places = corners(curve);
		darkest(first, followed, curve).ifPresent(d -> {
			if (places.stream().allMatch(c -> Math.abs(c - d) > SceneTuning.CORNER_REACH))
				places.add(d);
		});
		return places.stream().map(at -> fitted(seed, List.of(k),
			List.of(SceneSeeder.part(curve, 0, at), SceneSeeder.part(curve, at, curve.size() - 1))))
			.toList();
	}

	/** Where a curve, sampled at a pixel, turns most: a few points, the sharpest first. */
	private static List<Integer> corners(final Polyline curve) {
		final double[] turn = new double[curve.size()];
		for (int i = SceneTuning.CORNER_REACH; i < turn.length - SceneTuning.CORNER_REACH; i++)
			turn[i] = SceneSeeder.turn(curve, i);
		final List<Integer> corners = new ArrayList<>();
		IntStream.range(0, turn.length).boxed().filter(i -> turn[i] > SceneTuning.MEND_CORNER)
			.sorted(Comparator.comparingDouble(i -> -turn[i])).forEach(i -> {
				if (corners.size() < SceneTuning.MEND_CUTS && corners.stream()
					.allMatch(c -> Math.abs(c - i) > 2 * SceneTuning.CORNER_REACH))
					corners.add(i);
			});
		return corners;
	}

	/** The point of a curve at which the filament is darkest while it is followed. */
	private Optional<Integer> darkest(final int first, final List<Chain> followed,
		final Polyline curve) {
		final int links = followed.get(0).links();
		final double[] light = new double[links + 1];
		for (int t = first; t < first + followed.size(); t++) {
			final Polyline here = followed.get(t - first).polyline();
			for (int i = 0; i <= links; i++)
				light[i] += Math.min(1,
					line.frames().get(t).light().meanAround(here.x(i), here.y(i)));
		}
		return IntStream.rangeClosed(0, links).boxed()
			.filter(i -> at(i, links, curve) >= SceneTuning.CORNER_REACH
				&& at(i, links, curve) < curve.size() - SceneTuning.CORNER_REACH)
			.min(Comparator.comparingDouble(i -> light[i])).map(i -> at(i, links, curve));
	}

	/** The point of a curve at a node. */
	private static int at(final int node, final int links, final Polyline curve) {
		return (int) Math.round((double) node / links * (curve.size() - 1));
	}

	/**
	 * The best exchanges of what is behind a place where two filaments touch.
	 *
	 * @param seed all filaments of the frame
	 */
	List<Other> exchanges(final List<Chain> seed, final int i, final int j) {
		return TailSwap.ofAnyLength(seed.get(i), seed.get(j)).stream()
			.map(
				two -> fitted(seed, List.of(i, j), List.of(two.a().polyline(), two.b().polyline())))
			.sorted(Comparator.comparingDouble(Other::price)).limit(SceneTuning.MEND_EXCHANGES)
			.toList();
	}

	/** Others instead of some, fitted with their lengths free beside all others. */
	private Other fitted(final List<Chain> seed, final List<Integer> of,
		final List<Polyline> curves) {
		final List<Chain> all = new ArrayList<>(without(seed, of));
		final int held = all.size();
		curves.forEach(c -> all.add(Chain.inScene(c, c.length())));
		final Scene scene = line.scene(start, all);
		new JointFit(scene, weights, held).sweep(SceneTuning.SEED_SWEEPS);
		final List<Chain> chains = scene.chains();
		return new Other(of, List.copyOf(chains.subList(held, chains.size())),
			line.left(start, chains));
	}

	/** All but some. */
	static List<Chain> without(final List<Chain> chains, final List<Integer> out) {
		return IntStream.range(0, chains.size()).filter(k -> !out.contains(k)).mapToObj(chains::get)
			.toList();
	}
}
