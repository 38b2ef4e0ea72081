package io.github.knotresolver.evaluate;

import java.util.Arrays;

import io.github.knotresolver.contour.DiscreteFrechet;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.progress.Cancellation;

/**
 * How near one contour is to the true one. Both are resampled at 1 px; pixels
 * are the unit of every distance.
 *
 * @param truePositives points of the result within 2 px of a point of the truth
 * @param falsePositives other points of the result
 * @param falseNegatives points of the truth with no point of the result within
 *          2 px
 * @param frechet discrete Frechet distance (Eiter, Mannila 1994); the direction
 *          counts: fixed end first
 * @param frechetReversed the same with the result reversed: small if the ends
 *          were taken for each other
 * @param error mean distance of the result's points to the true curve
 * @param miss mean distance of the truth's points to the resulting curve
 * @param lengthError 100 · (length - true length) / true length
 */
public record CurveScore(int truePositives, int falsePositives, int falseNegatives, double frechet,
	double frechetReversed, double error, double miss, double lengthError) {

	/** A frame with a Frechet distance below this is resolved, in pixels. */
	public static final double RESOLVED_BELOW = 5;

	/** No result in this frame. */
	public static final CurveScore MISSING = new CurveScore(0, 0, 0, Double.POSITIVE_INFINITY,
		Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY, -100);

	/** A point this near to the other side counts as found, in pixels. */
	public static final double TOLERANCE = 2;

	private static final double COARSE = 1, FINE = 0.1;

	/**
	 * Compares a contour with the truth. O(n · m) in their lengths.
	 *
	 * @param truth the true contour, longer than 0
	 * @param result the contour to judge, longer than 0
	 * @return the score
	 * @throws IllegalArgumentException if a contour has no length
	 */
	public static CurveScore of(final Polyline truth, final Polyline result) {
		if (!(truth.length() > 0) || !(result.length() > 0))
			throw new IllegalArgumentException(
				"Contours to compare must be longer than 0 pixels, but are " + truth.length()
					+ " and " + result.length() + ".");
		final Polyline t = truth.resampled(COARSE), r = result.resampled(COARSE);
		final int found = found(nearestDistances(r, t));
		final int covered = found(nearestDistances(t, r));
		return new CurveScore(found, r.size() - found, t.size() - covered,
			DiscreteFrechet.distance(t, r), DiscreteFrechet.distance(t, r.reversed()),
			mean(positionErrors(truth, result)), mean(nearestDistances(t, result.resampled(FINE))),
			100 * (result.length() - truth.length()) / truth.length());
	}

	/**
	 * The position error along a contour, as the published evaluation counts it:
	 * minimal distances.
	 *
	 * @param truth the true contour
	 * @param result the contour to judge
	 * @return for a point every pixel of the result the distance to the true curve
	 *         in pixels
	 */
	public static double[] positionErrors(final Polyline truth, final Polyline result) {
		return nearestDistances(result.resampled(COARSE), truth.resampled(FINE));
	}

	/** @return the {@link #diceIndex Dice index}, 0..1; 0 if there is no result */
	public double dice() {
		return diceIndex(truePositives, falsePositives, falseNegatives);
	}

	/**
	 * The Sørensen-Dice index of points, as the published evaluation defines it: a
	 * point within 2 px of the other side's counts as found (Dice 1945,
	 * doi:10.2307/1932409).
	 *
	 * @param truePositives points of the result near the truth
	 * @param falsePositives other points of the result
	 * @param falseNegatives points of the truth with no point of the result near
	 * @return 2 TP / (2 TP + FP + FN), 0..1; 0 if there are no points at all
	 */
	public static double diceIndex(final int truePositives, final int falsePositives,
		final int falseNegatives) {
		final int all = 2 * truePositives + falsePositives + falseNegatives;
		return all == 0 ? 0 : 2.0 * truePositives / all;
	}

	/** @return how many of these distances are within the tolerance */
	static int found(final double[] distances) {
		return (int) Arrays.stream(distances).filter(d -> d <= TOLERANCE).count();
	}

	/** @return whether the Frechet distance is below 5 px */
	public boolean isResolved() {
		return frechet < RESOLVED_BELOW;
	}

	/** @return whether the contour is right, but from tip to fixed end */
	public boolean isFlipped() {
		return !isResolved() && frechetReversed < RESOLVED_BELOW;
	}

	private static double mean(final double[] values) {
		return Arrays.stream(values).average().orElse(Double.NaN);
	}

	/**
	 * Distances from points to the nearest point of a set. O(n · m).
	 *
	 * @param from n points
	 * @param to m points
	 * @return for every point of {@code from} the distance to the nearest of
	 *         {@code to}, in pixels
	 */
	static double[] nearestDistances(final Polyline from, final Polyline to) {
		return nearestDistances(from.xs(), from.ys(), to.xs(), to.ys());
	}

	/**
	 * The same of points in any order. O(n · m).
	 *
	 * @param fromX columns of n points
	 * @param fromY their rows
	 * @param toX columns of m points
	 * @param toY their rows
	 * @return for every point the distance to the nearest of the others, in pixels;
	 *         infinite if there are no others
	 */
	static double[] nearestDistances(final double[] fromX, final double[] fromY, final double[] toX,
		final double[] toY) {
		final double[] nearest = new double[fromX.length];
		for (int i = 0; i < nearest.length; i++) {
			Cancellation.check();
			nearest[i] = nearest(fromX[i], fromY[i], toX, toY);
		}
		return nearest;
	}

	private static double nearest(final double px, final double py, final double[] x,
		final double[] y) {
		double best = Double.POSITIVE_INFINITY;
		for (int j = 0; j < x.length; j++) {
			final double dx = x[j] - px, dy = y[j] - py;
			best = Math.min(best, dx * dx + dy * dy);
		}
		return Math.sqrt(best);
	}
}
