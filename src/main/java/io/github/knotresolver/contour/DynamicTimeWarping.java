
package io.github.knotresolver.contour;

import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.progress.Cancellation;

/**
 * Dynamic time warping of two curves: D(i,j) = |S(i) - R(j)| + min(D(i-1,j-1),
 * D(i-1,j), D(i,j-1)), the similarity score of the published method. Source: H.
 * Sakoe and S. Chiba, Dynamic programming algorithm optimization for spoken
 * word recognition, IEEE Trans. ASSP 26 (1978) 43-49,
 * doi:10.1109/TASSP.1978.1163055. Time O(nm), memory O(m).
 */
public final class DynamicTimeWarping {

	private DynamicTimeWarping() {
	}

	/**
	 * The least sum of point distances over all monotonic alignments that start
	 * at both first and end at both last points.
	 *
	 * @implNote op names="knotresolver.dynamicTimeWarping"
	 * @param a a curve
	 * @param b another
	 * @return D of the last points, in pixels; it grows with the number of points
	 */
	public static double distance(final Polyline a, final Polyline b) {
		return distance(a.xs(), a.ys(), b.xs(), b.ys());
	}

	/**
	 * The same per point, so that curves of different sampling compare.
	 *
	 * @param a a curve
	 * @param b another
	 * @return {@link #distance} divided by the larger number of points, in pixels
	 */
	public static double normalised(final Polyline a, final Polyline b) {
		return distance(a, b) / Math.max(a.size(), b.size());
	}

	static double distance(final double[] ax, final double[] ay, final double[] bx,
		final double[] by) {
		final int m = bx.length;
		final double[] row = new double[m];
		for (int i = 0; i < ax.length; i++) {
			Cancellation.check();
			double diagonal = i == 0 ? 0 : Double.POSITIVE_INFINITY;
			double left = Double.POSITIVE_INFINITY;
			for (int j = 0; j < m; j++) {
				final double above = i == 0 ? Double.POSITIVE_INFINITY : row[j];
				final double dx = ax[i] - bx[j], dy = ay[i] - by[j];
				left = Math.sqrt(dx * dx + dy * dy) + Math.min(diagonal, Math.min(above, left));
				row[j] = left;
				diagonal = above;
			}
		}
		return row[m - 1];
	}
}
