
package io.github.knotresolver.track;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;

import org.apache.commons.math3.stat.descriptive.rank.Median;

import io.github.knotresolver.fit.Chain;
import io.github.knotresolver.fit.Scene;
import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.progress.Progress;
import io.github.knotresolver.progress.Workers;
import io.github.knotresolver.track.SceneSettler.Settled;

/**
 * Two filaments one of which goes on where the other ends, in nearly all frames, are pieces of
 * one: each frame is explained by both, and nothing but the whole movie tells. So are two whose
 * ends touch in nearly all frames and which go on in most: a bend that slides through where they
 * meet does not part them. They are joined if the movie does not become dearer.
 */
final class JoinedPieces {

	private final SceneLine line;
	private final SceneWeights weights;
	private final Workers workers;
	private final Progress progress;

	JoinedPieces(final SceneLine line, final SceneWeights weights, final Workers workers,
		final Progress progress) {
		this.line = line;
		this.weights = weights;
		this.workers = workers;
		this.progress = progress;
	}

	/** The filaments, whole. O(filaments²) ends, O(frames) for pieces that fit. */
	List<Settled> joined(final List<Settled> filaments) {
		for (int i = 0; i < filaments.size(); i++)
			for (int j = i + 1; j < filaments.size(); j++)
				for (int ends = 0; ends < 4; ends++) {
					// The last end of one and the first of the other, whichever way they run.
					final List<Chain> a = turned(filaments.get(i), (ends & 1) > 0);
					final List<Chain> b = turned(filaments.get(j), (ends & 2) > 0);
					if (!goOn(a, b))
						continue;
					final Optional<List<Settled>> whole = whole(filaments, new int[]{i, j}, a, b);
					if (whole.isPresent())
						return joined(whole.get());
				}
		return filaments;
	}

	private static List<Chain> turned(final Settled filament, final boolean turned) {
		return turned
			? filament.chains().stream().map(Chain::reversed).toList()
			: filament.chains();
	}

	/**
	 * Whether the second goes on where the first ends in nearly all frames, or does so in most and
	 * both touch there in nearly all.
	 */
	private static boolean goOn(final List<Chain> a, final List<Chain> b) {
		int onwards = 0, touching = 0;
		for (int t = 0; t < a.size(); t++) {
			final Polyline p = a.get(t).polyline(), q = b.get(t).polyline();
			final double apart = p.last().distanceTo(q.first());
			onwards += apart <= SceneTuning.LEFT_NEAR && isAligned(p, q) ? 1 : 0;
			touching += apart <= SceneTuning.TOUCH ? 1 : 0;
		}
		final double nearlyAll = SceneTuning.PIECES_MOST * a.size();
		return onwards >= nearlyAll
			|| touching >= nearlyAll && onwards >= SceneTuning.PIECES_ALIGNED * a.size();
	}

	/** Whether the second sets out the way in which the first ends. */
	private static boolean isAligned(final Polyline a, final Polyline b) {
		final Point p = a.at(Math.max(0, a.length() - SceneTuning.LEFT_END)), end = a.last();
		final Point q = b.at(Math.min(b.length(), SceneTuning.LEFT_END)), start = b.first();
		final double ux = end.x() - p.x(), uy = end.y() - p.y();
		final double vx = q.x() - start.x(), vy = q.y() - start.y();
		return ux * vx + uy * vy > SceneTuning.LEFT_ALIGNED * Math.hypot(ux, uy)
			* Math.hypot(vx, vy);
	}

	private Optional<List<Settled>> whole(final List<Settled> filaments, final int[] two,
		final List<Chain> a, final List<Chain> b) {
		progress.checkCancelled();
		final int n = a.size();
		final List<Polyline> curves = new ArrayList<>();
		for (int t = 0; t < n; t++)
			curves.add(one(a.get(t).polyline(), b.get(t).polyline()));
		final double length = new Median()
			.evaluate(curves.stream().mapToDouble(Polyline::length).toArray());
		final List<Settled> others = new ArrayList<>(filaments);
		others.remove(Math.max(two[0], two[1]));
		others.remove(Math.min(two[0], two[1]));
		final List<Chain> chains = workers.map(n, t -> {
			final Scene scene = line.scene(t, others.stream().map(o -> o.chains().get(t)).toList());
			final Chain start = Chain.inScene(curves.get(t), length);
			return scene.window(List.of(start)).fit(start, Optional.of(start), weights.tracked())
				.chain();
		});
		final double[] gap = new double[n];
		Arrays.setAll(gap,
			t -> Math.min(filaments.get(two[0]).gap()[t], filaments.get(two[1]).gap()[t]));
		others.add(new Settled(chains, gap, Double.NaN));
		return ScenePass.of(others).price(line, workers) < ScenePass.of(filaments).price(line,
			workers) ? Optional.of(others) : Optional.empty();
	}

	/** Both curves in one; where they lie on each other, the second one's beginning is left out. */
	private static Polyline one(final Polyline a, final Polyline b) {
		final List<Point> points = new ArrayList<>();
		for (int i = 0; i < a.size(); i++)
			points.add(a.point(i));
		final Point end = a.last(), before = a.point(a.size() - 2);
		for (int i = 0; i < b.size(); i++)
			if (b.arc(i) > 2 * SceneTuning.LEFT_NEAR || (b.x(i) - end.x()) * (end.x() - before.x())
				+ (b.y(i) - end.y()) * (end.y() - before.y()) > 0)
				points.add(b.point(i));
		return Polyline.of(points);
	}
}
