
package io.github.knotresolver.simulate;

import java.util.ArrayList;
import java.util.List;

/**
 * The motors that hold the filament and those that may catch it. Motors out of
 * reach are not looked at until the filament has moved.
 */
final class Motors {

	/** How far beyond their reach motors are kept in view, in µm. */
	private static final double SKIN = 0.1;

	private final MotorProperties properties;
	private final MotorField field;
	private final List<Motor> bound = new ArrayList<>();
	private List<Motor> inView = List.of();
	private double[] viewX = {};
	private double[] viewY = {};

	Motors(final MotorProperties properties, final long seed) {
		this.properties = properties;
		field = new MotorField(properties.density(), seed);
	}

	/** @return the motors that hold the filament */
	List<Motor> bound() {
		return bound;
	}

	/** A step of time: bound motors walk and let go, free ones bind. */
	void step(final SimulatedChain chain, final double dt, final Noise noise) {
		for (final Motor m : bound)
			m.step(chain, properties, dt, noise);
		bound.removeIf(m -> !m.isBound());
		look(chain);
		final double chance = -StrictMath.expm1(-properties.bindingRate() * dt);
		for (final Motor m : inView)
			if (!m.isBound() && noise.uniform() < chance)
				tryToBind(m, chain);
	}

	private void tryToBind(final Motor motor, final SimulatedChain chain) {
		final double arc = chain.nearest(motor.x, motor.y, properties.bindingRange());
		if (Double.isNaN(arc) || arc >= chain.length())
			return;
		motor.bind(arc);
		bound.add(motor);
	}

	private void look(final SimulatedChain chain) {
		if (viewX.length > 0 && !hasMoved(chain))
			return;
		viewX = chain.x.clone();
		viewY = chain.y.clone();
		inView = field.near(chain, properties.bindingRange() + SKIN);
	}

	private boolean hasMoved(final SimulatedChain chain) {
		for (int i = 0; i < viewX.length; i++) {
			final double dx = chain.x[i] - viewX[i], dy = chain.y[i] - viewY[i];
			if (dx * dx + dy * dy > SKIN * SKIN)
				return true;
		}
		return false;
	}
}
