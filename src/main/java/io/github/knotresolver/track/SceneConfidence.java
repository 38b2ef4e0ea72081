
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

	private static final double GAP_SCALE = 2;

	/** Unexplained light (strands squared) that says nothing, and what leaves a third. */
	private static final double HARMLESS = 0.25, SCALE = 1;

	/** Multiples of usual motion that say nothing, and that leave hardly any confidence. */
	private static final double USUAL = 3, HOPELESS = 10, LEAST = 0.05;

	/** A filament may be unclear in this share of the frames, and no frame of it is doubtful. */
	private static final double SELDOM = 0.2;

	/** Light below this share of a strand's is hardly any. */
	private static final double DARK = 0.35;

	/** From this on nothing needs to be said. */
	private static final double SURE = 0.9;

	/** A contour is no surer than those of so many frames before and after it. */
	private static final int NEIGHBOURS = 5;

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
		return new double[]{1 - Math.exp(-gap / GAP_SCALE),
			Math.exp(-Math.max(0, unexplained - HARMLESS) / SCALE), 1 - dark,
			Math.min(1, Math.max(LEAST, (HOPELESS - haste) / (HOPELESS - USUAL))),
			Math.min(1, 1 + SELDOM - elsewhere)};
	}

	/** What lowers the confidence most, in words; empty if it is high. */
	String reason() {
		if (value() >= SURE)
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
			final Observation here = frames.get(t);
			final double least = frames
				.subList(Math.max(0, t - NEIGHBOURS), Math.min(frames.size(), t + NEIGHBOURS + 1))
				.stream().filter(o -> o.contour().isPresent()).mapToDouble(Observation::confidence)
				.min().orElse(1);
			cautious
				.add(here.contour().isEmpty() || least >= here.confidence()
					? here
					: here.withConfidence(least, !here.reason().isEmpty() || least >= SURE
						? here.reason()
						: "Doubtful: the contour of a frame just before or after this one is."));
		}
		return cautious;
	}

	/** The gap that alone would give a confidence. */
	static double gapOf(final double confidence) {
		return -GAP_SCALE * Math.log(Math.max(1e-12, 1 - confidence));
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
				if (light.meanAround(x, y) < DARK)
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
