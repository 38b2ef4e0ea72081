package io.github.knotresolver.evaluate;

import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.progress.Cancellation;

/** Distances from points to the nearest point of a set. */
final class NearestDistances {

	private NearestDistances() {
	}

	/**
	 * O(n · m).
	 *
	 * @param from n points
	 * @param to m points
	 * @return for every point of {@code from} the distance to the nearest of
	 *         {@code to}, in pixels
	 */
	static double[] of(final Polyline from, final Polyline to) {
		return of(from.xs(), from.ys(), to.xs(), to.ys());
	}

	/**
	 * O(n · m).
	 *
	 * @param fromX columns of n points
	 * @param fromY their rows
	 * @param toX columns of m points
	 * @param toY their rows
	 * @return for every point the distance to the nearest of the others, in pixels;
	 *         infinite if there are no others
	 */
	static double[] of(final double[] fromX, final double[] fromY, final double[] toX,
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
