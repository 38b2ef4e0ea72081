
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

	/** @return both ends and the length free, as in a frame of which nothing is known */
	FitSettings free() {
		return new FitSettings(stiffness, 0, 0, SceneTuning.FREE_ITERATIONS,
			SceneTuning.SCENE_TOLERANCE, true);
	}

	/** @return the same of a stiffer filament, for rough starts */
	FitSettings freeAndStiff() {
		return new FitSettings(SceneTuning.STIFFER * stiffness, 0, 0, SceneTuning.FREE_ITERATIONS,
			SceneTuning.SCENE_ROUGH, true);
	}

	/** @return of known length, nearly as predicted */
	FitSettings predicted() {
		return new FitSettings(stiffness, 0, SceneTuning.RIGID, SceneTuning.FEW_ITERATIONS,
			SceneTuning.SCENE_ROUGH, false);
	}

	/** @return of known length, loosely as predicted */
	FitSettings tracked() {
		return new FitSettings(stiffness, 0, SceneTuning.LOOSE, SceneTuning.LOOSE_ITERATIONS,
			SceneTuning.SCENE_TOLERANCE, false);
	}

	/** @return of known length, wherever the light is, fitted to the end */
	FitSettings settled() {
		return new FitSettings(stiffness, 0, 0, SceneTuning.LOOSE_ITERATIONS,
			SceneTuning.SCENE_EXACT, false);
	}

	/** @return the same for one of many that are tried: not fitted to the end */
	FitSettings searched() {
		return new FitSettings(stiffness, 0, SceneTuning.LOOSE, SceneTuning.SOME_ITERATIONS,
			SceneTuning.SCENE_FAIR, false);
	}
}
