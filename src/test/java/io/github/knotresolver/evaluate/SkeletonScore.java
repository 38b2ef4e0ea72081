package io.github.knotresolver.evaluate;

import io.github.knotresolver.geometry.Polyline;

/**
 * How near the pixels of a skeleton are to the true contour, whatever their
 * order: so the published evaluation judges segmentation.
 *
 * @param dice the {@link CurveScore#diceIndex Dice index} against a point every pixel of the truth,
 *          0..1; 0 if there is no skeleton
 * @param errors distance of every pixel to the true curve, in pixels
 */
public record SkeletonScore(double dice, double[] errors) {

	private static final double COARSE = 1, FINE = 0.1;

	/**
	 * Compares a skeleton with the truth. O(n · m) in pixels and length.
	 *
	 * @param truth the true contour in pixels
	 * @param x columns of the skeleton's pixels; may be empty
	 * @param y their rows
	 * @return the score
	 */
	public static SkeletonScore of(final Polyline truth, final double[] x, final double[] y) {
		final Polyline t = truth.resampled(COARSE), fine = truth.resampled(FINE);
		final int found = CurveScore.found(CurveScore.nearestDistances(x, y, t.xs(), t.ys()));
		final int covered = CurveScore.found(CurveScore.nearestDistances(t.xs(), t.ys(), x, y));
		return new SkeletonScore(CurveScore.diceIndex(found, x.length - found, t.size() - covered),
			CurveScore.nearestDistances(x, y, fine.xs(), fine.ys()));
	}
}
