
package io.github.knotresolver.fit;

import java.util.List;
import java.util.Optional;

/**
 * A part of a scene in which one chain is fitted while the others are drawn. It holds what
 * was drawn when it was opened. Not for several threads at a time.
 */
public final class SceneWindow {

	private final Patch patch;
	private final ImageTerm term;
	private final NormalizedFrame left;
	private final LineTables line;
	private final int links;

	SceneWindow(final Scene scene, final Patch patch, final int links) {
		this.patch = patch;
		this.links = links;
		final double[] pixels = patch.part(scene.light()).pixels();
		final double[] others = scene.picture(patch);
		line = scene.line();
		final double[] rest = pixels.clone();
		for (int i = 0; i < rest.length; i++)
			rest[i] -= others[i];
		left = new NormalizedFrame(patch.width(), patch.height(), rest);
		term = ImageTerm.of(line.additive() == line
			? left
			: new NormalizedFrame(patch.width(), patch.height(), pixels), line, links, others);
	}

	/**
	 * The same chain with its last links grown anew along the light that others leave.
	 *
	 * @param chain the chain
	 * @param tip how many links, fewer than it has
	 * @param settings weights
	 * @return a few chains, the most promising first
	 */
	public List<Chain> regrown(final Chain chain, final int tip, final FitSettings settings) {
		return new TipBeam(left, line, settings.stiffness(), chain.linkLength())
			.grown(here(chain), tip).stream().map(c -> c.shifted(patch.left(), patch.top()))
			.toList();
	}

	/**
	 * The best chain near a start.
	 *
	 * @param start where to begin
	 * @param predicted the shape it is expected to have, if there is one
	 * @param settings weights
	 * @return the fit; its energy is what the chain explains (negative) and its bending
	 */
	public Fit fit(final Chain start, final Optional<Chain> predicted, final FitSettings settings) {
		return there(new FilamentFitter(term, links, Optional.empty(), settings).fit(here(start),
			predicted));
	}

	/**
	 * A chain as it is.
	 *
	 * @param chain the chain
	 * @param settings weights
	 * @return its prices
	 */
	public Fit price(final Chain chain, final FitSettings settings) {
		return there(
			new FilamentFitter(term, links, Optional.empty(), settings).price(here(chain)));
	}

	/**
	 * The cheapest of some chains as they are; O(chains * links).
	 *
	 * @param chains at least one
	 * @param settings weights
	 * @return the first of those that cost least
	 */
	public Chain cheapest(final List<Chain> chains, final FitSettings settings) {
		Chain best = chains.get(0);
		double lowest = Double.POSITIVE_INFINITY;
		for (final Chain chain : chains) {
			final double energy = price(chain, settings).energy();
			if (energy < lowest) {
				lowest = energy;
				best = chain;
			}
		}
		return best;
	}

	private Chain here(final Chain chain) {
		return chain.shifted(-patch.left(), -patch.top());
	}

	private Fit there(final Fit fit) {
		return new Fit(fit.chain().shifted(patch.left(), patch.top()), fit.light(), fit.energy(),
			fit.iterations());
	}
}
