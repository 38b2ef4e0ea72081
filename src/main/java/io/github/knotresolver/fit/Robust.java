
package io.github.knotresolver.fit;

/**
 * The robust price of a residual, rho(r) = r² / (1 + r²/c²): quadratic where
 * the model explains the light, flat where something else shines, so that a
 * foreign filament does not pull (Geman and McClure 1987).
 */
final class Robust {

	/** For one filament among what is not modelled. */
	static final Robust ALONE = new Robust(FitTuning.ROBUST);

	/**
	 * For filaments that are all modelled: where strands lie close, a residual of a whole
	 * strand must still pull.
	 */
	static final Robust TOGETHER = new Robust(2 * FitTuning.ROBUST);

	private final double inverseSquare;

	private Robust(final double scale) {
		inverseSquare = 1 / (scale * scale);
	}

	double price(final double residual) {
		final double r2 = residual * residual;
		return r2 / (1 + r2 * inverseSquare);
	}

	/** Weight of the residual in the normal equations: d rho / d r². */
	double weight(final double residual) {
		final double w = 1 / (1 + residual * residual * inverseSquare);
		return w * w;
	}
}
