
package io.github.knotresolver.track;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

import io.github.knotresolver.fit.Chain;
import io.github.knotresolver.fit.NormalizedFrame;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.model.Observation;

/**
 * How sure a filament's contour in a frame is: near 1 only if no other way through the movie
 * is nearly as cheap (an exchange of identities would be), all light around it is explained,
 * light is under all of it, and it moved as it usually does.
 *
 * @param gap how much dearer the cheapest movie becomes with another contour here
 * @param unexplained the most light that is not explained around any of its points
 * @param dark share of its length with hardly any light
 * @param haste motion since the frame before and to the one after, the larger one, as a
 *          multiple of the usual
 * @param elsewhere share of the movie's frames in which light around this filament is not
 *          explained, as far as that may be the fault of its length or identity
 */
record SceneConfidence(double gap, double unexplained, double dark, double haste,
	double elsewhere) {

	/** What lowers a confidence, in the order of {@link #factors}. */
	private static final List<String> WORDS = List.of(
		"another course of the filaments explains the movie nearly as well",
		"light around the contour is not explained", "parts of the contour run in the dark",
		"the contour moved much farther than usual",
		"in many other frames this filament does not explain the light");

	double value() {
		return Arrays.stream(factors()).reduce(1, (a, b) -> a * b);
	}

	private double[] factors() {
		return new double[]{1 - Math.exp(-gap / SceneTuning.SCENE_GAP),
			Math.exp(
				-Math.max(0, unexplained - SceneTuning.HARMLESS_LIGHT) / SceneTuning.LIGHT_SCALE),
			1 - dark,
			Math.min(1,
				Math.max(SceneTuning.LEAST_OF_HASTE,
					(SceneTuning.HOPELESS_HASTE - haste)
						/ (SceneTuning.HOPELESS_HASTE - SceneTuning.USUAL_HASTE))),
			Math.min(1, 1 + SceneTuning.SELDOM_UNCLEAR - elsewhere)};
	}

	/** What lowers the confidence most, in words; empty if it is high. */
	String reason() {
		if (value() >= Observation.SURE)
			return "";
		final double[] factors = factors();
		int worst = 0;
		for (int i = 1; i < factors.length; i++)
			if (factors[i] < factors[worst])
				worst = i;
		return "Doubtful: " + WORDS.get(worst) + ".";
	}

	/**
	 * Filaments are followed from frame to frame, so that one that has gone astray stays
	 * astray for a while: no contour is surer than those shortly before and after it.
	 *
	 * @param frames a filament's observations, in order of time
	 * @return the same with confidences that are never raised
	 */
	static List<Observation> together(final List<Observation> frames) {
		final List<Observation> cautious = new ArrayList<>();
		for (int t = 0; t < frames.size(); t++) {
			final double least = frames
				.subList(Math.max(0, t - SceneTuning.LIKE_NEIGHBOURS),
					Math.min(frames.size(), t + SceneTuning.LIKE_NEIGHBOURS + 1))
				.stream().filter(o -> o.contour().isPresent()).mapToDouble(Observation::confidence)
				.min().orElse(1);
			cautious.add(frames.get(t).atMost(least,
				"Doubtful: the contour of a frame just before or after this one is."));
		}
		return cautious;
	}

	/** The gap that alone would give a confidence. */
	static double gapOf(final double confidence) {
		return -SceneTuning.SCENE_GAP * Math.log(Math.max(1e-12, 1 - confidence));
	}

	/** The share of a chain's length, as far as it is in view, that lies in the dark. */
	static double dark(final NormalizedFrame light, final Chain chain) {
		final Polyline curve = chain.polyline();
		int inside = 0, dark = 0;
		for (int i = 0; i + 1 < curve.size(); i++) {
			final double x = 0.5 * (curve.x(i) + curve.x(i + 1));
			final double y = 0.5 * (curve.y(i) + curve.y(i + 1));
			if (isInside(light, x, y)) {
				inside++;
				if (light.meanAround(x, y) < SceneTuning.DARK_LIGHT)
					dark++;
			}
		}
		return inside == 0 ? 1 : (double) dark / inside;
	}

	/** The share of a chain's length that lies inside the picture. */
	static double visible(final NormalizedFrame light, final Chain chain) {
		final Polyline curve = chain.polyline();
		int inside = 0;
		for (int i = 0; i + 1 < curve.size(); i++)
			if (isInside(light, 0.5 * (curve.x(i) + curve.x(i + 1)),
				0.5 * (curve.y(i) + curve.y(i + 1))))
				inside++;
		return (double) inside / (curve.size() - 1);
	}

	private static boolean isInside(final NormalizedFrame light, final double x, final double y) {
		return x > -0.5 && y > -0.5 && x < light.width() - 0.5 && y < light.height() - 0.5;
	}
}
