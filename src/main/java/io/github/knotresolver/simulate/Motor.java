
package io.github.knotresolver.simulate;

/** A motor fixed to the surface; it may hold the filament. µm, pN. */
final class Motor {

	final double x;
	final double y;

	/** Where it holds the filament, as arc length; NaN if it does not. */
	private double arc = Double.NaN;

	Motor(final double x, final double y) {
		this.x = x;
		this.y = y;
	}

	boolean isBound() {
		return !Double.isNaN(arc);
	}

	double arc() {
		return arc;
	}

	void bind(final double where) {
		arc = where;
	}

	void release() {
		arc = Double.NaN;
	}

	/**
	 * A step of time while bound: walks under load and may let go, at random or
	 * at the filament's end.
	 */
	void step(final SimulatedChain chain, final MotorProperties p, final double dt,
		final Noise noise) {
		final int i = chain.linkAt(arc);
		final double f = arc / chain.link - i;
		final double tx = chain.x[i + 1] - chain.x[i], ty = chain.y[i + 1] - chain.y[i];
		final double fx = p.stiffness() * (x - chain.x[i] - f * tx);
		final double fy = p.stiffness() * (y - chain.y[i] - f * ty);
		final double along = (fx * tx + fy * ty) / chain.link;
		arc += p.speedUnder(along) * dt;
		final double rate = p.unbindingRateUnder(Math.sqrt(fx * fx + fy * fy));
		if (noise.uniform() < -StrictMath.expm1(-rate * dt) || arc >= chain.length())
			release();
	}
}
