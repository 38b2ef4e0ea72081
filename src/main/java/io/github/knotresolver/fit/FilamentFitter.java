
package io.github.knotresolver.fit;

import java.util.Optional;

import io.github.knotresolver.geometry.Angles;
import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.progress.Cancellation;

/**
 * Fits chains to one frame by damped least squares (Levenberg-Marquardt,
 * doi:10.1137/0111030) with the analytic Jacobian of the image term. The energy
 * of a chain is
 *
 * <pre>
 * Σ rho(I - M) + stiffness Σ Δθ² / h + clampWeight |P0 - clamp|² + memory h Σ |θ - θ_predicted|²
 * </pre>
 *
 * A step takes O(length) for the picture and O(links) for a banded system; where strands add
 * up, or the length is fitted, far nodes are coupled and the system is dense, O(links³). Keeps scratch memory: one thread at a time.
 */
public final class FilamentFitter {

	private final ImageTerm image;
	private final Optional<Point> clamp;
	private final FitSettings settings;
	private final int links;
	private NodeSystem nodes;
	private final double[] x;
	private final double[] y;

	/**
	 * @param frame the frame
	 * @param model what a line looks like
	 * @param links number of links of all chains to come, at least 2
	 * @param clamp where the fixed end is, in pixels; empty if both ends are free
	 * @param settings weights
	 */
	public FilamentFitter(final NormalizedFrame frame, final LineModel model, final int links,
		final Optional<Point> clamp, final FitSettings settings) {
		this(ImageTerm.of(frame, model, links), links, clamp, settings);
	}

	FilamentFitter(final ImageTerm image, final int links, final Optional<Point> clamp,
		final FitSettings settings) {
		this.image = image;
		this.clamp = clamp;
		this.settings = settings;
		this.links = links;
		x = new double[links + 1];
		y = new double[links + 1];
	}

	/** @return number of links of all chains it fits */
	public int links() {
		return links;
	}

	/**
	 * The best chain near a start: of the same length, unless the settings let the length
	 * go.
	 *
	 * @param start where to begin
	 * @param predicted the shape it is expected to have, if there is one
	 * @return the fit
	 */
	public Fit fit(final Chain start, final Optional<Chain> predicted) {
		return fit(start, predicted, Double.POSITIVE_INFINITY);
	}

	/**
	 * The best chain near a start, unless that is too dear to be worth it.
	 *
	 * @param start where to begin
	 * @param predicted the shape it is expected to have, if there is one
	 * @param dearest an energy: a fit that would stay above it even if all steps to come gained as
	 *            much as the last two is given up where it is
	 * @return the fit
	 */
	public Fit fit(final Chain start, final Optional<Chain> predicted, final double dearest) {
		final boolean freeLength = settings.freeLength();
		if (nodes == null)
			nodes = new NodeSystem(links + 1, image.couplesFarNodes() || freeLength ? links : 1);
		final StepSystem system = image.couplesFarNodes() || freeLength
			? new ReducedSystem(links, freeLength)
			: new ChainSystem(links);
		Chain chain = start;
		double light = light(chain, true);
		double energy = light + priors(chain, predicted);
		double damping = 1e-3, lastGain = Double.POSITIVE_INFINITY;
		int iteration = 0;
		while (iteration < settings.iterations()) {
			Cancellation.check();
			image.linearize(x, y, nodes);
			system.reduce(nodes, x, y, chain.linkLength());
			addPriors(system, chain, predicted);
			final double before = energy;
			Chain best = null;
			for (int attempt = 0; attempt < FitTuning.ATTEMPTS && best == null; attempt++) {
				Cancellation.check();
				final Chain trial = step(system, chain, damping, freeLength);
				final double trialLight = trial == null ? Double.NaN : light(trial, true);
				final double trialEnergy = trial == null
					? Double.NaN
					: trialLight + priors(trial, predicted);
				if (trialEnergy < energy) {
					best = trial;
					light = trialLight;
					energy = trialEnergy;
					damping = Math.max(damping / 5, 1e-6);
				} else
					damping = Math.max(damping * 6, 1e-5);
			}
			if (best == null)
				break;
			chain = best;
			iteration++;
			final double gain = before - energy;
			if (gain < settings.tolerance() * Math.abs(before) || energy
				- Math.max(gain, lastGain) * (settings.iterations() - iteration) > dearest)
				break;
			lastGain = gain;
		}
		return new Fit(chain, light, light + stiffnessAndClamp(chain), iteration);
	}

	/**
	 * The energy of a chain as it is.
	 *
	 * @param chain the chain
	 * @return the chain with its prices
	 */
	public Fit price(final Chain chain) {
		final double light = light(chain, false);
		return new Fit(chain, light, light + stiffnessAndClamp(chain), 0);
	}

	private double light(final Chain chain, final boolean keep) {
		chain.nodes(x, y);
		return image.evaluate(x, y, links, keep);
	}

	private double priors(final Chain chain, final Optional<Chain> predicted) {
		return stiffnessAndClamp(chain) + predicted.map(p -> memory(chain, p)).orElse(0.0);
	}

	private double stiffnessAndClamp(final Chain chain) {
		double bend = 0;
		for (int i = 1; i < links; i++) {
			final double d = chain.angle(i) - chain.angle(i - 1);
			bend += d * d;
		}
		final double off = clamp.map(c -> c.distanceTo(chain.start())).orElse(0.0);
		return settings.stiffness() / chain.linkLength() * bend
			+ settings.clampWeight() * off * off;
	}

	private double memory(final Chain chain, final Chain predicted) {
		final double turn = fullTurns(chain, predicted);
		double sum = 0;
		for (int i = 0; i < links; i++) {
			final double d = chain.angle(i) - predicted.angle(i) - turn;
			sum += d * d;
		}
		return settings.memory() * chain.linkLength() * sum;
	}

	/**
	 * Angles are continuous along a chain, but two chains may differ by full
	 * turns.
	 */
	private static double fullTurns(final Chain chain, final Chain predicted) {
		final int middle = chain.links() / 2;
		return Angles.nearest(predicted.angle(middle), chain.angle(middle))
			- predicted.angle(middle);
	}

	private void addPriors(final StepSystem system, final Chain chain,
		final Optional<Chain> predicted) {
		final double bend = settings.stiffness() / chain.linkLength();
		for (int i = 1; i < links; i++)
			system.addBend(i, bend, bend * (chain.angle(i) - chain.angle(i - 1)));
		final double w = settings.clampWeight();
		clamp.ifPresent(c -> system.addStart(w, w * (chain.start().x() - c.x()),
			w * (chain.start().y() - c.y())));
		if (predicted.isPresent()) {
			final double hold = settings.memory() * chain.linkLength();
			final double turn = fullTurns(chain, predicted.get());
			for (int i = 0; i < links; i++)
				system.addAngle(i, hold, hold * (chain.angle(i) - predicted.get().angle(i) - turn));
		}
	}

	/** A damped step, or null if the system is singular even so. */
	private Chain step(final StepSystem system, final Chain chain, final double damping,
		final boolean freeLength) {
		final double[] step = system.solve(damping);
		if (step == null)
			return null;
		double turn = 0;
		for (int i = 2; i < links + 2; i++)
			turn = Math.max(turn, Math.abs(step[i]));
		final double scale = turn > FitTuning.LARGEST_TURN ? FitTuning.LARGEST_TURN / turn : 1;
		final double largest = FitTuning.LARGEST_STRETCH * chain.linkLength();
		final double stretch = freeLength
			? Math.max(-largest, Math.min(largest, scale * step[links + 2]))
			: 0;
		return chain.moved(step, scale, stretch);
	}
}
