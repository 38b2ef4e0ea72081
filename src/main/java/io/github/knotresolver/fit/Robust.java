
package io.github.knotresolver.fit;

/**
 * The robust price of a residual, rho(r) = r² / (1 + r²/c²): quadratic where
 * the model explains the light, flat where something else shines, so that a
 * foreign filament does not pull (Geman and McClure 1987).
 */
final class Robust {

	/** Residual at which the price begins to level off, in strand intensities. */
	static final double SCALE = 0.35;

	private static final double INVERSE_SQUARE = 1 / (SCALE * SCALE);

	private Robust() {
	}

	static double price(final double residual) {
		final double r2 = residual * residual;
		return r2 / (1 + r2 * INVERSE_SQUARE);
	}

	/** Weight of the residual in the normal equations: d rho / d r². */
	static double weight(final double residual) {
		final double w = 1 / (1 + residual * residual * INVERSE_SQUARE);
		return w * w;
	}
}
