package io.github.knotresolver.image;

/**
 * What lies on the two sides of a line, at the pixels where there may be one. A line
 * falls off on both sides, an edge on one.
 */
final class RidgeSides {

	/** Where the negative lobes beside a line are looked for, in line widths. */
	private static final double[] LOBES = {1.1, 1.45, 1.8};

	private final Hessian hessian;
	private final RidgeStrength ridges;
	private final double reach;
	private final float[] drop, smallest;
	private final boolean[] crest, edge;

	/**
	 * Looks at the pixels that are stronger than a limit.
	 *
	 * @param reach how far to both sides is looked, in pixels: the standard deviation of
	 *          the line as the filter blurs it
	 * @param low the limit at every pixel
	 */
	RidgeSides(final Hessian hessian, final RidgeStrength ridges, final double reach,
		final float[] low) {
		this.hessian = hessian;
		this.ridges = ridges;
		this.reach = reach;
		drop = new float[low.length];
		smallest = new float[low.length];
		crest = new boolean[low.length];
		edge = new boolean[low.length];
		for (int at = 0; at < low.length; at++)
			if (ridges.strength(at) > low[at])
				look(at);
	}

	/** @return the mean drop of brightness to both sides; 0 where there is no line */
	float drop(final int at) {
		return drop[at];
	}

	/** @return all of {@link #drop(int)}; not to be changed */
	float[] drops() {
		return drop;
	}

	/** @return the drop to the side where it is smaller, over the mean of both */
	float balance(final int at) {
		return drop[at] > 0 ? smallest[at] / drop[at] : 0;
	}

	/** @return whether the strength is largest here, across the line */
	boolean isCrest(final int at) {
		return crest[at];
	}

	/** @return whether this crest is rather an edge than a line */
	boolean isEdge(final int at) {
		return edge[at];
	}

	private void look(final int at) {
		final int width = hessian.width();
		final double x = at % width, y = at / width;
		final double c = Math.cos(ridges.angle(at)), s = Math.sin(ridges.angle(at));
		double here = 0, left = 0, right = 0;
		for (int i = -1; i <= 1; i++) {
			final double u = x + i * c * reach, v = y + i * s * reach;
			here += at(hessian.smooth(), u, v) / 3;
			left += at(hessian.smooth(), u - reach * s, v + reach * c) / 3;
			right += at(hessian.smooth(), u + reach * s, v - reach * c) / 3;
		}
		drop[at] = (float) (here - (left + right) / 2);
		smallest[at] = (float) (here - Math.max(left, right));
		final float strength = ridges.strength(at);
		crest[at] = strength >= at(ridges.strengths(), x - s, y + c)
			&& strength > at(ridges.strengths(), x + s, y - c);
		if (crest[at]) {
			final double a = lobe(x, y, c, s), b = lobe(x, y, -c, -s);
			edge[at] = Math.max(a, b) > -ImageTuning.NO_LOBE * strength
				&& Math.min(a, b) < -ImageTuning.LOBE * strength;
		}
	}

	/** The most negative strength on one side. */
	private double lobe(final double x, final double y, final double c, final double s) {
		double lowest = Double.POSITIVE_INFINITY;
		for (final double far : LOBES) {
			double response = 0;
			for (final double i : new double[]{-0.5, 0.5}) {
				final double u = x + (i * c - far * s) * reach, v = y + (i * s + far * c) * reach;
				response += s * c * at(hessian.xy(), u, v) - s * s * at(hessian.xx(), u, v) / 2
					- c * c * at(hessian.yy(), u, v) / 2;
			}
			lowest = Math.min(lowest, response);
		}
		return lowest;
	}

	private double at(final float[] values, final double x, final double y) {
		return Pixels.between(values, hessian.width(), x, y);
	}
}
