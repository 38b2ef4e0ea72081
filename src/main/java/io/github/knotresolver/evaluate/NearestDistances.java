package io.github.knotresolver.evaluate;

import io.github.knotresolver.geometry.Polyline;

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
		final double[] x = to.xs(), y = to.ys();
		final double[] nearest = new double[from.size()];
		for (int i = 0; i < nearest.length; i++)
			nearest[i] = nearest(from.x(i), from.y(i), x, y);
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
