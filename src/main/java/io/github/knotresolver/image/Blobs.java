package io.github.knotresolver.image;

/**
 * Bright spots that are as narrow along as across: beads, debris, motors. Where strands
 * cross it looks the same, so this alone never takes anything away.
 */
final class Blobs {

	/** A spot's mean curvature is above this part of the limit: 0.75 of it if it is just round, less for rounding. */
	private static final double LEAST_MEAN = 0.7;

	/** Spots are looked for that are as wide as the line, and as wide as so many. */
	private static final int WIDE = 2;

	private final int width;
	private final boolean[] near;

	/**
	 * @param clean the frame, lines bright
	 * @param hessian its derivatives
	 * @param sigma of their filter
	 * @param limit curvature below which nothing is looked at, at every pixel
	 * @param reach standard deviation of the line as the filter blurs it
	 */
	Blobs(final float[] clean, final Hessian hessian, final double sigma, final float[] limit,
		final double reach) {
		width = hessian.width();
		near = new boolean[clean.length];
		mark(hessian, limit, 1, ImageTuning.SPOT_REACH * reach);
		if (Math.min(width, hessian.height()) >= 16 * WIDE)
			mark(Hessian.of(Binning.mean(clean, width, WIDE), width / WIDE, sigma), limit, WIDE,
				ImageTuning.SPOT_REACH * reach * WIDE);
	}

	/** @return whether a pixel is near the middle of a spot */
	boolean isNear(final int at) {
		return near[at];
	}

	private void mark(final Hessian h, final float[] limit, final int binning,
		final double radius) {
		for (int y = 1; y < h.height() - 1; y++)
			for (int x = 1; x < h.width() - 1; x++) {
				final int at = y * h.width() + x;
				final float most = limit[y * binning * width + x * binning];
				if (mean(h, at) > LEAST_MEAN * most && isTop(h, at) && isRound(h, at, most))
					mark(x * binning + (binning - 1) / 2.0, y * binning + (binning - 1) / 2.0,
						radius);
			}
	}

	private static double mean(final Hessian h, final int at) {
		return -(h.xx()[at] + h.yy()[at]) / 2;
	}

	private static boolean isRound(final Hessian h, final int at, final double limit) {
		final double mean = mean(h, at);
		final double across = (h.xx()[at] - h.yy()[at]) / 2, xy = h.xy()[at];
		final double half = Math.sqrt(across * across + xy * xy);
		return mean + half > limit && mean - half > ImageTuning.ROUND * (mean + half);
	}

	private static boolean isTop(final Hessian h, final int at) {
		for (int v = -1; v <= 1; v++)
			for (int u = -1; u <= 1; u++)
				if (h.smooth()[at + v * h.width() + u] > h.smooth()[at])
					return false;
		return true;
	}

	private void mark(final double x, final double y, final double radius) {
		final int height = near.length / width;
		for (int v = (int) Math.max(0, y - radius); v <= Math.min(height - 1, y + radius); v++)
			for (int u = (int) Math.max(0, x - radius); u <= Math.min(width - 1, x + radius); u++)
				if ((u - x) * (u - x) + (v - y) * (v - y) <= radius * radius)
					near[v * width + u] = true;
	}
}
