
package io.github.knotresolver.track;

import java.util.List;

import io.github.knotresolver.fit.Chain;
import io.github.knotresolver.fit.NormalizedFrame;
import io.github.knotresolver.fit.Scene;
import io.github.knotresolver.geometry.Polyline;

/**
 * What the chains of a scene do not explain, pixel by pixel: light that is missing and light
 * that is too much, above the noise, in strands squared. Each pixel counts at most
 * 0.25, so that one bright spot does not decide.
 */
final class Unexplained {

	private final int width;
	private final int height;
	private final double[] map;
	private final int[] stamp;
	private int stamps;

	/**
	 * @param scene a frame with its chains
	 * @param noise of a pixel in strands
	 */
	Unexplained(final Scene scene, final double noise) {
		final NormalizedFrame left = scene.residual().blurred(TrackTuning.RESIDUE_BLUR);
		width = left.width();
		height = left.height();
		map = left.pixels();
		stamp = new int[map.length];
		final double floor = Math.max(TrackTuning.RESIDUE_LEAST,
			Math.pow(TrackTuning.RESIDUE_NOISES * SceneTuning.CALMED * noise, 2));
		for (int i = 0; i < map.length; i++) {
			final double square = map[i] * map[i];
			map[i] = Math.max(0, square / (1 + square / TrackTuning.RESIDUE_LEVEL) - floor);
		}
	}

	/** The sum within the set pixels. */
	double within(final boolean[] set) {
		double sum = 0;
		for (int i = 0; i < map.length; i++)
			if (set[i])
				sum += map[i];
		return sum;
	}

	/** The sum around some curves, each pixel once. */
	double around(final Iterable<Chain> chains) {
		stamps++;
		double sum = 0;
		for (final Chain chain : chains) {
			final Polyline curve = chain.polyline();
			for (int i = 0; i < curve.size(); i++)
				sum += aroundNode(curve.x(i), curve.y(i));
		}
		return sum;
	}

	/** The largest sum around any node of a chain. */
	double worst(final Chain chain) {
		final Polyline curve = chain.polyline();
		double worst = 0;
		for (int i = 0; i < curve.size(); i++) {
			stamps++;
			worst = Math.max(worst, aroundNode(curve.x(i), curve.y(i)));
		}
		return worst;
	}

	/** Whether the light around a chain is explained. */
	boolean isClear(final Chain chain) {
		return worst(chain) <= SceneTuning.UNCLEAR_LIGHT;
	}

	/**
	 * The largest sum around any node of a chain, or of other chains where they run beside it: two
	 * that have exchanged a part leave light around one of them only.
	 *
	 * @param chain one of the scene
	 * @param all the scene's chains
	 */
	double worstBeside(final Chain chain, final List<Chain> all) {
		double worst = worst(chain);
		final Polyline curve = chain.polyline();
		for (final Chain other : all) {
			final Polyline beside = other.polyline();
			for (int i = 0; i < beside.size() && other != chain; i++)
				if (isBeside(curve, beside.x(i), beside.y(i))) {
					stamps++;
					worst = Math.max(worst, aroundNode(beside.x(i), beside.y(i)));
				}
		}
		return worst;
	}

	private static boolean isBeside(final Polyline curve, final double x, final double y) {
		for (int i = 0; i < curve.size(); i++)
			if (Math.hypot(curve.x(i) - x, curve.y(i) - y) < SceneTuning.BESIDE)
				return true;
		return false;
	}

	private double aroundNode(final double x, final double y) {
		double sum = 0;
		for (int row = Math.max(0, (int) Math.ceil(y - TrackTuning.RESIDUE_NEAR)); row <= Math
			.min(height - 1, (int) Math.floor(y + TrackTuning.RESIDUE_NEAR)); row++)
			for (int c = Math.max(0, (int) Math.ceil(x - TrackTuning.RESIDUE_NEAR)); c <= Math
				.min(width - 1, (int) Math.floor(x + TrackTuning.RESIDUE_NEAR)); c++) {
				final int at = row * width + c;
				if (stamp[at] != stamps
					&& (c - x) * (c - x) + (row - y) * (row - y) <= TrackTuning.RESIDUE_NEAR
						* TrackTuning.RESIDUE_NEAR) {
					stamp[at] = stamps;
					sum += map[at];
				}
			}
		return sum;
	}
}
