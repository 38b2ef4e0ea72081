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
 * @param freeLength whether the length is fitted, too
 */
public record FitSettings(double stiffness, double clampWeight, double memory, int iterations,
	double tolerance, boolean freeLength) {

	/** Defaults for tracking. */
	public static final FitSettings DEFAULT = new FitSettings(0.9, 3, 0.007, 25, 2e-4, false);

	/** A fit with both ends and the length free: nothing but the light says where it ends. */
	public static final FitSettings ENDS_FREE = new FitSettings(0.9, 0, 0, 40, 1e-5, true);

	/**
	 * Price of bending of a fit that starts from a skeleton: a skeleton has kinks where
	 * strands lie side by side and where debris sticks to a line, a filament has none.
	 */
	public static final double START_STIFFNESS = 20;

	/**
	 * Price of bending where noise drowns single pixels: a fit that bends easily follows the
	 * noise, and its wiggles make it too long.
	 */
	public static final double NOISY_STIFFNESS = 5;

	/**
	 * @param price of bending
	 * @return the same otherwise
	 */
	public FitSettings withStiffness(final double price) {
		return new FitSettings(price, clampWeight, memory, iterations, tolerance, freeLength);
	}

	/**
	 * A filament is as stiff in noise as elsewhere: what a bend costs is a share of the noise, as soon
	 * as that is more than what else a line differs by from its model.
	 *
	 * @param noise of a pixel
	 * @param drowning the noise that drowns single pixels, in the same unit
	 * @return the same with the price of bending in that noise
	 */
	public FitSettings inNoise(final double noise, final double drowning) {
		final double share = noise / drowning;
		return withStiffness(Math.max(stiffness, Math.min(1, share * share) * NOISY_STIFFNESS));
	}

	/** @return whether noise drowns single pixels */
	public boolean isNoisy() {
		return stiffness >= NOISY_STIFFNESS;
	}

	/**
	 * @param price of leaving the fixed end, per square pixel
	 * @return the same otherwise
	 */
	public FitSettings withClampWeight(final double price) {
		return new FitSettings(stiffness, price, memory, iterations, tolerance, freeLength);
	}

	/**
	 * @param free whether the length is fitted, too
	 * @return the same otherwise
	 */
	public FitSettings withFreeLength(final boolean free) {
		return new FitSettings(stiffness, clampWeight, memory, iterations, tolerance, free);
	}

	/**
	 * @param price of bending
	 * @return settings for a rough fit of a stiff filament
	 */
	public FitSettings roughAndStiff(final double price) {
		return new FitSettings(price, clampWeight, memory, iterations / 2, 10 * tolerance,
			freeLength);
	}
}
