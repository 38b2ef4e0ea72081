package io.github.knotresolver.model;

import java.util.Objects;
import java.util.OptionalDouble;

/**
 * Parameters of finding the filament's mask.
 *
 * @param steps which steps lead to the mask
 * @param threshold intensity 0..1 of the stretched frame above which a pixel
 *          starts as filament; empty for Otsu's
 * @param iterations of the active contour, 0..1000; 0 leaves the threshold's
 *          mask
 * @param contractionBias -1..1; positive shrinks the mask
 * @param smoothFactor 0..10; the larger, the smoother the outline
 */
public record Segmentation(Steps steps, OptionalDouble threshold, int iterations,
	double contractionBias, double smoothFactor) {

	/** Which steps lead to a mask. Those alone are the baselines of the paper. */
	public enum Steps {
		/** In every frame a threshold, then the active contour. */
		BOTH,
		/** A threshold alone; the active contour's parameters have no say. */
		THRESHOLD,
		/**
		 * Only the first frame has a threshold; the active contour then goes on from
		 * frame to frame.
		 */
		ACTIVE_CONTOUR
	}

	/** The defaults of the published method. */
	public static final Segmentation DEFAULT = new Segmentation(Steps.BOTH, OptionalDouble.empty(),
		10, 0.4, 0.2);

	public Segmentation {
		Objects.requireNonNull(steps);
		if (threshold.isPresent()
			&& !(threshold.getAsDouble() >= 0 && threshold.getAsDouble() <= 1))
			throw new UserException(
				"threshold must be from 0 to 1, or otsu, but is " + threshold.getAsDouble() + ".");
		if (iterations < 0 || iterations > 1000)
			throw new UserException(
				"iterations must be from 0 to 1000, but is " + iterations + ".");
		if (!(contractionBias >= -1 && contractionBias <= 1))
			throw new UserException(
				"contraction_bias must be from -1 to 1, but is " + contractionBias + ".");
		if (!(smoothFactor >= 0 && smoothFactor <= 10))
			throw new UserException(
				"smooth_factor must be from 0 to 10, but is " + smoothFactor + ".");
	}

	/**
	 * @param value which steps lead to the mask
	 * @return the same with that
	 */
	public Segmentation withSteps(final Steps value) {
		return new Segmentation(value, threshold, iterations, contractionBias, smoothFactor);
	}

	/**
	 * @param value intensity 0..1; empty for the automatic one
	 * @return the same with that
	 */
	public Segmentation withThreshold(final OptionalDouble value) {
		return new Segmentation(steps, value, iterations, contractionBias, smoothFactor);
	}

	/**
	 * @param value of the active contour, 0..1000
	 * @return the same with that
	 */
	public Segmentation withIterations(final int value) {
		return new Segmentation(steps, threshold, value, contractionBias, smoothFactor);
	}

	/**
	 * @param value -1..1
	 * @return the same with that
	 */
	public Segmentation withContractionBias(final double value) {
		return new Segmentation(steps, threshold, iterations, value, smoothFactor);
	}

	/**
	 * @param value 0..10
	 * @return the same with that
	 */
	public Segmentation withSmoothFactor(final double value) {
		return new Segmentation(steps, threshold, iterations, contractionBias, value);
	}
}
