package io.github.knotresolver.fit;

/**
 * Weights of the fit, in normalised intensities squared.
 *
 * @param stiffness price of bending: stiffness · Σ Δθ² / linkLength, in pixels
 * @param clampWeight price of leaving the fixed end, per square pixel
 * @param memory price of leaving the predicted shape, per radian² and pixel of
 *          length
 * @param iterations largest number of accepted steps
 * @param tolerance relative gain of a step below which the fit has converged
 */
public record FitSettings(double stiffness, double clampWeight, double memory, int iterations,
	double tolerance) {

	/** Defaults for tracking. */
	public static final FitSettings DEFAULT = new FitSettings(0.9, 3, 0.007, 25, 2e-4);

	/** @return the same with another price of leaving the fixed end */
	public FitSettings withClampWeight(final double weight) {
		return new FitSettings(stiffness, weight, memory, iterations, tolerance);
	}
}
