
package io.github.knotresolver.simulate;

/**
 * Where the filament is: nodes joined by links of equal length. Node 0 is the
 * clamped end. µm.
 */
final class SimulatedChain {

	final double[] x;
	final double[] y;
	final double link;

	/** A straight chain from the origin along x. */
	SimulatedChain(final int links, final double length) {
		x = new double[links + 1];
		y = new double[links + 1];
		link = length / links;
		for (int i = 0; i <= links; i++)
			x[i] = i * link;
	}

	int nodes() {
		return x.length;
	}

	double length() {
		return link * (nodes() - 1);
	}

	/** @return index of the link that holds an arc length */
	int linkAt(final double arc) {
		return Math.max(0, Math.min(nodes() - 2, (int) (arc / link)));
	}

	/** @return distance between the two nodes of a link */
	double distance(final int i) {
		final double dx = x[i + 1] - x[i], dy = y[i + 1] - y[i];
		return Math.sqrt(dx * dx + dy * dy);
	}

	/** @return the largest relative error of a link's length */
	double worstStrain() {
		double worst = 0;
		for (int i = 0; i < nodes() - 1; i++)
			worst = Math.max(worst, Math.abs(distance(i) - link));
		return worst / link;
	}

	/**
	 * The arc length of the point nearest to a place, if it is within reach.
	 * O(n).
	 *
	 * @param px place in µm
	 * @param py place in µm
	 * @param reach largest distance in µm
	 * @return arc length in µm, or NaN
	 */
	double nearest(final double px, final double py, final double reach) {
		double best = reach * reach, found = Double.NaN;
		for (int i = 0; i < nodes() - 1; i++) {
			final double dx = x[i + 1] - x[i], dy = y[i + 1] - y[i];
			final double ox = px - x[i], oy = py - y[i];
			final double f = Math.max(0, Math.min(1, (ox * dx + oy * dy) / (link * link)));
			final double ex = ox - f * dx, ey = oy - f * dy;
			final double squared = ex * ex + ey * ey;
			if (squared <= best) {
				best = squared;
				found = (i + f) * link;
			}
		}
		return found;
	}
}
