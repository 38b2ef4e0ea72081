
package io.github.knotresolver.simulate;

import java.util.List;

/**
 * One implicit step of the filament: drag, bending, the motors' springs,
 * thermal forces and the tension that keeps every link's length, solved
 * together.
 * <p>
 * The displacements d and tensions t solve the saddle-point system (drag/dt +
 * K) d + Gᵀ t = f + noise, G d = 0, where K is the stiffness of bending and
 * springs and G holds the links' directions. Backward Euler alone would cool
 * the modes that relax within a step. The noise therefore has two parts: forces
 * of variance 2 kT drag/dt on every node, and forces of covariance kT K, drawn
 * element by element; together they give every mode of the linear system the
 * variance kT/K of equilibrium, whatever the time step.
 */
final class FilamentMechanics {

	private static final int BAND = 6;

	/** Relative error of a link that is left to the length keeper. */
	private static final double STRAIN = 1e-4;

	/** Most rounds of correcting lengths by the factored system. */
	private static final int ROUNDS = 8;

	private final double bending;
	private final double drag;
	private final double kT;
	private final double spring;
	private final double dt;
	private final int held;
	private final BandedSystem system;
	private final LengthKeeper keeper;
	private final double[] tension;

	FilamentMechanics(final SimulationParameters p, final SimulatedChain chain, final double dt) {
		this.dt = dt;
		kT = p.medium().thermalEnergy();
		bending = p.rigidity() / (chain.link * chain.link * chain.link);
		drag = p.medium().dragPerLength() * chain.link;
		spring = p.motors().stiffness();
		held = p.filament().clamp().heldNodes();
		system = new BandedSystem(3 * chain.nodes(), BAND);
		keeper = new LengthKeeper(chain.nodes() - 1, held);
		tension = new double[chain.nodes() - 1];
	}

	/** @return the tension of every link after the last step, in pN */
	double[] tension() {
		return tension.clone();
	}

	/** Moves the filament by one step of time. */
	void step(final SimulatedChain chain, final List<Motor> bound, final Noise noise) {
		system.clear();
		addDrag(chain, noise);
		addBending(chain, noise);
		for (final Motor m : bound)
			addSpring(chain, m, noise);
		addLinks(chain);
		for (int i = 0; i < held; i++)
			for (int k = 0; k < 2; k++)
				system.hold(3 * i + k);
		system.factor();
		final double[] solution = system.solve();
		apply(chain, solution);
		for (int i = 1; i < chain.nodes(); i++)
			tension[i - 1] = solution[3 * i + 2];
		for (int round = 0; round < ROUNDS && chain.worstStrain() > STRAIN; round++)
			correctLengths(chain);
		keeper.restore(chain);
	}

	/** Links that have turned are too long: one round of the chord method. */
	private void correctLengths(final SimulatedChain chain) {
		system.clearRight();
		for (int i = Math.max(1, held); i < chain.nodes(); i++)
			system.addRight(3 * i + 2, chain.link - chain.distance(i - 1));
		apply(chain, system.solve());
	}

	private void addDrag(final SimulatedChain chain, final Noise noise) {
		final int last = chain.nodes() - 1;
		for (int i = 0; i <= last; i++) {
			final double mobility = (i == 0 || i == last ? 0.5 : 1) * drag / dt;
			final double kick = Math.sqrt(2 * kT * mobility);
			for (int k = 0; k < 2; k++) {
				system.add(3 * i + k, 3 * i + k, mobility);
				system.addRight(3 * i + k, kick * noise.gaussian());
			}
		}
	}

	private void addBending(final SimulatedChain chain, final Noise noise) {
		final double kick = Math.sqrt(kT * bending);
		for (int i = 1; i < chain.nodes() - 1; i++) {
			addCurvature(chain.x, i, 0, kick * noise.gaussian());
			addCurvature(chain.y, i, 1, kick * noise.gaussian());
		}
	}

	/** The energy bending/2 (a - 2 b + c)² of three nodes, one coordinate. */
	private void addCurvature(final double[] r, final int i, final int k, final double kick) {
		final int a = 3 * i - 3 + k, b = 3 * i + k, c = 3 * i + 3 + k;
		final double force = kick - bending * (r[i - 1] - 2 * r[i] + r[i + 1]);
		system.add(a, a, bending);
		system.add(b, b, 4 * bending);
		system.add(c, c, bending);
		system.add(b, a, -2 * bending);
		system.add(c, b, -2 * bending);
		system.add(c, a, bending);
		system.addRight(a, force);
		system.addRight(b, -2 * force);
		system.addRight(c, force);
	}

	private void addSpring(final SimulatedChain chain, final Motor m, final Noise noise) {
		final int i = chain.linkAt(m.arc());
		final double f = m.arc() / chain.link - i;
		final double kick = Math.sqrt(kT * spring);
		addPull(chain.x, i, 0, f, m.x, kick * noise.gaussian());
		addPull(chain.y, i, 1, f, m.y, kick * noise.gaussian());
	}

	private void addPull(final double[] r, final int i, final int k, final double f,
		final double anchor, final double kick) {
		final int a = 3 * i + k, b = 3 * i + 3 + k;
		final double force = kick + spring * (anchor - (1 - f) * r[i] - f * r[i + 1]);
		system.add(a, a, spring * (1 - f) * (1 - f));
		system.add(b, a, spring * (1 - f) * f);
		system.add(b, b, spring * f * f);
		system.addRight(a, (1 - f) * force);
		system.addRight(b, f * force);
	}

	/** The unknown 3 i + 2 is the tension of the link that ends at node i. */
	private void addLinks(final SimulatedChain chain) {
		system.add(2, 2, -1);
		for (int i = 1; i < chain.nodes(); i++) {
			final int t = 3 * i + 2;
			if (i < held) {
				system.add(t, t, -1);
				continue;
			}
			final double d = chain.distance(i - 1);
			final double tx = (chain.x[i] - chain.x[i - 1]) / d;
			final double ty = (chain.y[i] - chain.y[i - 1]) / d;
			system.add(t, 3 * i, tx);
			system.add(t, 3 * i + 1, ty);
			system.add(t, 3 * i - 3, -tx);
			system.add(t, 3 * i - 2, -ty);
			system.addRight(t, chain.link - d);
		}
	}

	private static void apply(final SimulatedChain chain, final double[] solution) {
		for (int i = 0; i < chain.nodes(); i++) {
			chain.x[i] += solution[3 * i];
			chain.y[i] += solution[3 * i + 1];
		}
	}
}
