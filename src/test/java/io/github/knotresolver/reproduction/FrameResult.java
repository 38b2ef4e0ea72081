package io.github.knotresolver.reproduction;

import io.github.knotresolver.evaluate.CurveScore;

/**
 * How one method did in one frame.
 *
 * @param series the filament
 * @param condition what was asked
 * @param method the method
 * @param frame 1-based, of the movie with all frames
 * @param crossings of the true contour with itself
 * @param dice Dice index of the skeleton's or the contour's points
 * @param frechet discrete Frechet distance in pixels; infinite without a contour,
 *          NaN for a method that gives none
 * @param errors distances of its points to the true curve, in pixels
 */
public record FrameResult(Series series, Condition condition, Method method, int frame,
	int crossings, double dice, double frechet, double[] errors) {

	/** @return whether the contour is right all along */
	public boolean isResolved() {
		return frechet < CurveScore.RESOLVED_BELOW;
	}
}
