package io.github.knotresolver.model;

import java.util.Objects;
import java.util.OptionalDouble;

/**
 * Parameters of finding the filament's mask.
 *
 * @param steps which steps lead to the mask
 * @param polarity whether filaments are bright or dark, or to be found
 * @param threshold intensity 0..1 of the stretched frame above which a pixel
 *          starts as filament; empty for Otsu's
 * @param iterations of the active contour, 0..1000; 0 leaves the threshold's
 *          mask
 * @param contractionBias -1..1; positive shrinks the mask
 * @param smoothFactor 0..10; the larger, the smoother the outline
 */
public record Segmentation(Steps steps, Polarity polarity, OptionalDouble threshold, int iterations,
	double contractionBias, double smoothFactor) {

	/** Which steps lead to a mask. Two of them alone are the baselines of the paper. */
	public enum Steps {
		/** Ridges in units of noise, thinned and cleaned: no parameter has a part in it. */
		EVIDENCE,
		/** In every frame a threshold, then the active contour. */
		BOTH,
		/** A threshold alone; the active contour's parameters are not used. */
		THRESHOLD,
		/**
		 * Only the first frame has a threshold; the active contour then goes on from
		 * frame to frame.
		 */
		ACTIVE_CONTOUR
	}

	/** The defaults of the published method. */
	public static final Segmentation PUBLISHED = new Segmentation(Steps.BOTH, Polarity.AUTO,
		OptionalDouble.empty(), 10, 0.4, 0.2);

	/** The defaults of our method. */
	public static final Segmentation DEFAULT = PUBLISHED.withSteps(Steps.EVIDENCE);

	public Segmentation {
		Objects.requireNonNull(steps);
		Objects.requireNonNull(polarity);
		if (threshold.isPresent()
			&& !(threshold.getAsDouble() >= 0 && threshold.getAsDouble() <= 1))
			throw new UserException("threshold must be from 0 to 1, or otsu, but is "
				+ ShownNumber.of(threshold.getAsDouble()) + ".");
		if (iterations < 0 || iterations > 1000)
			throw new UserException(
				"iterations must be from 0 to 1000, but is " + iterations + ".");
		if (!(contractionBias >= -1 && contractionBias <= 1))
			throw new UserException("contraction_bias must be from -1 to 1, but is "
				+ ShownNumber.of(contractionBias) + ".");
		if (!(smoothFactor >= 0 && smoothFactor <= 10))
			throw new UserException(
				"smooth_factor must be from 0 to 10, but is " + ShownNumber.of(smoothFactor) + ".");
	}

	/**
	 * @param value which steps lead to the mask
	 * @return the same with that
	 */
	public Segmentation withSteps(final Steps value) {
		return new Segmentation(value, polarity, threshold, iterations, contractionBias,
			smoothFactor);
	}

	/**
	 * @param value intensity 0..1; empty for the automatic one
	 * @return the same with that
	 */
	public Segmentation withThreshold(final OptionalDouble value) {
		return new Segmentation(steps, polarity, value, iterations, contractionBias, smoothFactor);
	}

	/**
	 * @param value of the active contour, 0..1000
	 * @return the same with that
	 */
	public Segmentation withIterations(final int value) {
		return new Segmentation(steps, polarity, threshold, value, contractionBias, smoothFactor);
	}

	/**
	 * @param value -1..1
	 * @return the same with that
	 */
	public Segmentation withContractionBias(final double value) {
		return new Segmentation(steps, polarity, threshold, iterations, value, smoothFactor);
	}

	/**
	 * @param value 0..10
	 * @return the same with that
	 */
	public Segmentation withSmoothFactor(final double value) {
		return new Segmentation(steps, polarity, threshold, iterations, contractionBias, value);
	}

	/**
	 * @param value bright, dark or to be found
	 * @return the same with that
	 */
	public Segmentation withPolarity(final Polarity value) {
		return new Segmentation(steps, value, threshold, iterations, contractionBias, smoothFactor);
	}

	/** @return whether threshold and active contour are as they are by default */
	public boolean isAutomatic() {
		return threshold.isEmpty() && iterations == PUBLISHED.iterations
			&& contractionBias == PUBLISHED.contractionBias
			&& smoothFactor == PUBLISHED.smoothFactor;
	}
}
