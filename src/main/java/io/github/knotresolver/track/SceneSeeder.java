
package io.github.knotresolver.track;

import java.util.ArrayList;
import java.util.List;

import io.github.knotresolver.candidate.SceneTrails;
import io.github.knotresolver.fit.Chain;
import io.github.knotresolver.fit.LineTables;
import io.github.knotresolver.fit.Scene;
import io.github.knotresolver.geometry.GaussianSmoothing;
import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.geometry.Polyline;

/**
 * All filaments of one frame, neither their number nor their lengths known: the trails of
 * the graph, fitted together; what they leave unexplained makes them longer or becomes new
 * chains; what explains too little goes.
 */
final class SceneSeeder {

	private final LineTables line;
	private final SceneWeights weights;

	SceneSeeder(final LineTables line, final SceneWeights weights) {
		this.line = line;
		this.weights = weights;
	}

	/**
	 * The chains of a frame.
	 *
	 * @param frame its light in strands
	 * @param known chains that are known; they come first and stay as they are
	 */
	List<Chain> chains(final FrameView frame, final List<Chain> known) {
		final int held = known.size();
		final List<Chain> all = new ArrayList<>(known);
		all.addAll(starts(held == 0 ? frame : SceneRemainder.of(frame, line, known)));
		final Scene scene = new Scene(frame.light(), line, all);
		new JointFit(scene, weights, held).sweep(SceneTuning.FIRST_SWEEPS);
		Scene now = scene;
		for (int round = 0; round < SceneTuning.SEED_ROUNDS; round++) {
			now = new Scene(frame.light(), line, UnexplainedLight.mended(now, held));
			new JointFit(now, weights, held).sweep(SceneTuning.SEED_SWEEPS);
			now = new Scene(frame.light(), line, worthTheirPrice(now, held));
		}
		new JointFit(now, weights, held).sweep(SceneTuning.SEED_SWEEPS);
		return now.chains();
	}

	/** The trails of a frame as chains, not fitted. */
	static List<Chain> starts(final FrameView frame) {
		final List<Chain> chains = new ArrayList<>();
		for (final Polyline trail : trails(frame).curves())
			for (final Polyline piece : pieces(smooth(trail)))
				if (piece.length() >= SceneTuning.FILAMENT_SHORTEST) {
					final Polyline whole = lengthened(piece);
					chains.add(Chain.inScene(whole, whole.length()));
				}
		return chains;
	}

	static SceneTrails.Found trails(final FrameView frame) {
		return SceneTrails.of(frame.graph(), c -> SceneLine.brightness(frame.light(), c));
	}

	private static Polyline smooth(final Polyline trail) {
		final Polyline even = trail.resampled(1);
		return even.size() > 2
			? GaussianSmoothing.gaussian(even, SceneTuning.SEED_SMOOTH).resampled(1)
			: even;
	}

	/** Cuts a curve, sampled at a pixel, at its corners. */
	private static List<Polyline> pieces(final Polyline curve) {
		int corner = -1;
		double sharpest = SceneTuning.SEED_CORNER;
		for (int i = SceneTuning.CORNER_REACH; i < curve.size() - SceneTuning.CORNER_REACH; i++) {
			final double turn = turn(curve, i);
			if (turn > sharpest) {
				sharpest = turn;
				corner = i;
			}
		}
		if (corner < 0 || curve.size() < 3 * SceneTuning.CORNER_REACH)
			return List.of(curve);
		final List<Polyline> all = new ArrayList<>(pieces(part(curve, 0, corner)));
		all.addAll(pieces(part(curve, corner, curve.size() - 1)));
		return all;
	}

	static double turn(final Polyline c, final int i) {
		final int a = i - SceneTuning.CORNER_REACH, b = i + SceneTuning.CORNER_REACH;
		final double ux = c.x(i) - c.x(a), uy = c.y(i) - c.y(a);
		final double vx = c.x(b) - c.x(i), vy = c.y(b) - c.y(i);
		return Math.abs(Math.atan2(ux * vy - uy * vx, ux * vx + uy * vy));
	}

	static Polyline part(final Polyline curve, final int from, final int to) {
		final List<Point> points = new ArrayList<>();
		for (int i = from; i <= to; i++)
			points.add(curve.point(i));
		return Polyline.of(points);
	}

	private static Polyline lengthened(final Polyline curve) {
		return UnexplainedLight
			.extended(UnexplainedLight.extended(curve, SceneTuning.SEED_HIDDEN).reversed(),
				SceneTuning.SEED_HIDDEN)
			.reversed();
	}

	private List<Chain> worthTheirPrice(final Scene scene, final int held) {
		final List<Chain> kept = new ArrayList<>(scene.chains().subList(0, held));
		for (int k = held; k < scene.size(); k++) {
			final Chain chain = scene.chain(k);
			scene.take(k);
			final double explained = -scene.window(List.of(chain)).price(chain, weights.free())
				.light();
			if (explained > SceneTuning.FILAMENT_LIGHT
				&& chain.length() > SceneTuning.FILAMENT_SHORTEST) {
				scene.put(k, chain);
				kept.add(chain);
			}
		}
		return kept;
	}
}
