
package io.github.knotresolver.track;

import java.util.List;

import io.github.knotresolver.fit.Chain;
import io.github.knotresolver.fit.FitSettings;
import io.github.knotresolver.fit.LineModel;
import io.github.knotresolver.fit.Scene;
import io.github.knotresolver.fit.SceneWindow;

/**
 * How much a frame tells of where along its own track a filament is. Where light does not add
 * up, one that lies under another changes nothing in the picture, and may slide there unseen:
 * then its place is a guess, however well the picture is explained.
 */
final class Hiding {

	private final FitSettings settings;

	/** @param weights of the fit */
	Hiding(final SceneWeights weights) {
		settings = weights.tracked();
	}

	/**
	 * How much dearer a movie is at least in which a filament lies visibly elsewhere in a frame, as
	 * far as that frame's light tells.
	 *
	 * @param scene a frame with its chains; the same when this returns
	 * @param k the number of one of them
	 * @return as the gap of a {@link SceneConfidence}; never so little that this alone rules a
	 *         contour out: where it is hidden, a filament is most likely where it was heading
	 */
	double gap(final Scene scene, final int k) {
		return Math.max(SceneConfidence.gapOf(SceneTuning.LEAST_OF_HIDDEN),
			SceneTuning.SCENE_GAP * shown(scene, k) / SceneTuning.HIDDEN_LIGHT);
	}

	/**
	 * What more the picture would leave unexplained if a filament had slid along itself so far
	 * that it is visibly elsewhere, the less of both directions. O(length).
	 *
	 * @param scene a frame with its chains; the same when this returns
	 * @param k the number of one of them
	 * @return in strands squared, at least 0; infinite where strands add up, since there each
	 *         shows wherever it lies
	 */
	double shown(final Scene scene, final int k) {
		if (scene.line().model().kind() == LineModel.Kind.ADDITIVE)
			return Double.POSITIVE_INFINITY;
		final Chain here = scene.chain(k), back = here.slid(-SceneTuning.VISIBLY_FAR),
			ahead = here.slid(SceneTuning.VISIBLY_FAR);
		scene.take(k);
		final SceneWindow window = scene.window(List.of(here, back, ahead));
		final double elsewhere = Math.min(light(window, back), light(window, ahead));
		final double shown = elsewhere - light(window, here);
		scene.put(k, here);
		return Math.max(0, shown);
	}

	private double light(final SceneWindow window, final Chain chain) {
		return window.price(chain, settings).light();
	}
}
