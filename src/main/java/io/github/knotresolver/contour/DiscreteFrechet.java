
package io.github.knotresolver.contour;

import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.progress.Cancellation;

/**
 * Discrete Frechet distance: the shortest leash with which two walkers get from
 * the first to the last points of two curves without stepping back. Source: T.
 * Eiter and H. Mannila, Computing discrete Frechet distance, TU Wien, CD-TR
 * 94/64, 1994. Time O(nm), memory O(m).
 */
public final class DiscreteFrechet {

	private DiscreteFrechet() {
	}

	/**
	 * The discrete Frechet distance. The direction of the curves counts.
	 *
	 * @implNote op names="knotresolver.frechetDistance"
	 * @param a a curve
	 * @param b another
	 * @return the length of the leash in pixels
	 */
	public static double distance(final Polyline a, final Polyline b) {
		final int m = b.size();
		final double[] row = new double[m];
		for (int i = 0; i < a.size(); i++) {
			Cancellation.check();
			double diagonal = i == 0 ? 0 : Double.POSITIVE_INFINITY;
			double left = Double.POSITIVE_INFINITY;
			for (int j = 0; j < m; j++) {
				final double above = i == 0 ? Double.POSITIVE_INFINITY : row[j];
				final double d = Math.hypot(a.x(i) - b.x(j), a.y(i) - b.y(j));
				left = Math.max(d, Math.min(diagonal, Math.min(above, left)));
				row[j] = left;
				diagonal = above;
			}
		}
		return row[m - 1];
	}
}
