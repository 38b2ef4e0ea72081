
package io.github.knotresolver.track;

import java.util.List;
import java.util.Optional;

import io.github.knotresolver.fit.Chain;
import io.github.knotresolver.fit.Fit;
import io.github.knotresolver.fit.FitSettings;
import io.github.knotresolver.fit.Scene;

/**
 * Fits all chains of a frame of which nothing is known before, ends and lengths free: one at
 * a time, with the others drawn, until none moves.
 */
final class JointFit {

	private final Scene scene;
	private final SceneWeights weights;
	private final int held;

	JointFit(final Scene scene, final SceneWeights weights) {
		this(scene, weights, 0);
	}

	/** @param held so many of the first chains are known and stay as they are */
	JointFit(final Scene scene, final SceneWeights weights, final int held) {
		this.scene = scene;
		this.weights = weights;
		this.held = held;
	}

	/** Lowers the energy of all chains together in a number of sweeps, the first one stiff. */
	void sweep(final int sweeps) {
		final double[] moved = new double[scene.size()];
		for (int s = 0; s < sweeps; s++)
			for (int k = held; k < scene.size(); k++)
				if (s < 2 || isRestless(k, moved))
					moved[k] = fit(k, s == 0 ? weights.freeAndStiff() : weights.free());
	}

	private boolean isRestless(final int k, final double[] moved) {
		for (int other = 0; other < moved.length; other++)
			if (moved[other] > SceneTuning.SWEEP_STILL && (other == k || scene.mayTouch(k, other)))
				return true;
		return false;
	}

	private double fit(final int k, final FitSettings settings) {
		final Chain before = scene.chain(k);
		scene.take(k);
		final Fit fit = scene.window(List.of(before)).fit(before, Optional.empty(), settings);
		final Chain after = fit.chain();
		final double moved = before.distance(after);
		scene.put(k, after.length() < SceneTuning.SHORTEST_CHAIN ? before : relinked(after));
		return moved;
	}

	private static Chain relinked(final Chain chain) {
		return chain.linkLength() >= SceneTuning.SHORTEST_LINK
			&& chain.linkLength() <= SceneTuning.LONGEST_LINK
				? chain
				: Chain.inScene(chain.polyline(), chain.length());
	}
}
