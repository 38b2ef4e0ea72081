
package io.github.knotresolver.track;

import io.github.knotresolver.fit.FitSettings;

/**
 * Weights with which the filaments of a scene are fitted.
 *
 * @param stiffness price of bending
 */
record SceneWeights(double stiffness) {

	/** For filaments that bend over several widths, as microtubules do. */
	static final SceneWeights DEFAULT = new SceneWeights(4);

	/** For filaments that turn around within a few widths, as actin does. */
	static final SceneWeights SUPPLE = new SceneWeights(0.7);

	/** Memory of the predicted shape, per radian² and pixel: nearly rigid, then loose. */
	private static final double RIGID = 3, LOOSE = 0.5;

	private static final int FREE_ITERATIONS = 12, FEW_ITERATIONS = 6, SOME_ITERATIONS = 8,
		ITERATIONS = 25;
	private static final double TOLERANCE = 4e-4, FAIR = 1e-3, ROUGH = 2e-3;
	private static final double STIFFER = 4;

	/** @return both ends and the length free, as in a frame of which nothing is known */
	FitSettings free() {
		return new FitSettings(stiffness, 0, 0, FREE_ITERATIONS, TOLERANCE, true);
	}

	/** @return the same of a stiffer filament, for rough starts */
	FitSettings freeAndStiff() {
		return new FitSettings(STIFFER * stiffness, 0, 0, FREE_ITERATIONS, ROUGH, true);
	}

	/** @return of known length, nearly as predicted */
	FitSettings predicted() {
		return new FitSettings(stiffness, 0, RIGID, FEW_ITERATIONS, ROUGH, false);
	}

	/** @return of known length, loosely as predicted */
	FitSettings tracked() {
		return new FitSettings(stiffness, 0, LOOSE, ITERATIONS, TOLERANCE, false);
	}

	/** @return the same for one of many that are tried: not fitted to the end */
	FitSettings searched() {
		return new FitSettings(stiffness, 0, LOOSE, SOME_ITERATIONS, FAIR, false);
	}
}
