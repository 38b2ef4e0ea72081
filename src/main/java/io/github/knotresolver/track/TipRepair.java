
package io.github.knotresolver.track;

import java.util.List;
import java.util.Optional;

import io.github.knotresolver.fit.Chain;
import io.github.knotresolver.fit.Fit;
import io.github.knotresolver.fit.FitSettings;
import io.github.knotresolver.fit.Scene;
import io.github.knotresolver.fit.SceneWindow;
import io.github.knotresolver.geometry.Point;

/**
 * Ends that turned: where light is missing or too much near an end, its last pixels are grown
 * anew, also of the filament slid a little along its track. Kept if that is cheaper.
 */
final class TipRepair {

	/** Slides that are tried (pixels). */
	private static final double[] SLIDES = {0, 2, -2, 4, -4};

	/** Lengths of tips that are grown anew (pixels). */
	private static final double[] TIPS = {9, 18};

	private final Scene scene;
	private final FitSettings settings;
	private final double mismatch;

	/**
	 * @param scene a frame with all its chains drawn
	 * @param settings weights
	 * @param mismatch light that is missing or too much, in strands, from which on an end is
	 *          looked at
	 */
	TipRepair(final Scene scene, final FitSettings settings, final double mismatch) {
		this.scene = scene;
		this.settings = settings;
		this.mismatch = mismatch;
	}

	/** Mends a chain, if that is better. */
	void mend(final int k) {
		final Chain chain = scene.chain(k);
		final boolean first = isWrong(chain.start()), last = isWrong(chain.polyline().last());
		if (!first && !last)
			return;
		scene.take(k);
		final SceneWindow window = scene.window(List.of(chain));
		final double before = window.price(chain, settings).energy();
		Chain best = chain;
		double lowest = before - SceneTuning.TIP_PROMISING;
		for (final double slide : SLIDES) {
			final Chain base = chain.slid(slide);
			for (final double tip : TIPS) {
				if (last)
					for (final Chain c : regrown(window, base, tip)) {
						final double energy = window.price(c, settings).energy();
						if (energy < lowest) {
							lowest = energy;
							best = c;
						}
					}
				if (first)
					for (final Chain c : regrown(window, base.reversed(), tip)) {
						final double energy = window.price(c.reversed(), settings).energy();
						if (energy < lowest) {
							lowest = energy;
							best = c.reversed();
						}
					}
			}
		}
		final boolean mended = best != chain
			&& keep(k, window.fit(best, Optional.of(best), settings), before);
		if (!mended)
			scene.put(k, chain);
	}

	private boolean keep(final int k, final Fit fit, final double before) {
		if (fit.energy() > before - SceneTuning.TIP_BETTER)
			return false;
		scene.put(k, fit.chain());
		return true;
	}

	private List<Chain> regrown(final SceneWindow window, final Chain chain, final double tip) {
		return window.regrown(chain,
			Math.max(1, Math.min(chain.links() / 2, (int) Math.rint(tip / chain.linkLength()))),
			settings);
	}

	private boolean isWrong(final Point end) {
		final int x = (int) Math.rint(end.x()), y = (int) Math.rint(end.y());
		for (int row = y - SceneTuning.TIP_NEAR; row <= y + SceneTuning.TIP_NEAR; row++)
			for (int c = x - SceneTuning.TIP_NEAR; c <= x + SceneTuning.TIP_NEAR; c++)
				if (Math.abs(scene.mismatch(c, row)) > mismatch)
					return true;
		return false;
	}
}
