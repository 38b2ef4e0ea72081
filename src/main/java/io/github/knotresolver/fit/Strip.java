package io.github.knotresolver.fit;

/**
 * A rectangle along a link, row by row: the pixels that can matter for it, without those
 * in the corners of its bounding box.
 */
final class Strip {

	private static final double PARALLEL = 1e-9;

	private double ux;
	private double uy;
	private double begin;
	private double end;
	private double reach;

	private double low;
	private double high;

	/**
	 * Lays the strip.
	 *
	 * @param ux direction of the link, a unit vector
	 * @param uy direction of the link
	 * @param begin along the link, in pixels from its start, usually negative
	 * @param end along the link, in pixels from its start
	 * @param reach half width across the link in pixels
	 */
	void lay(final double ux, final double uy, final double begin, final double end,
		final double reach) {
		this.ux = ux;
		this.uy = uy;
		this.begin = begin;
		this.end = end;
		this.reach = reach;
	}

	/** Half the height of the strip's bounding box above the link's start. */
	double top() {
		return Math.min(begin * uy, end * uy) - reach * Math.abs(ux);
	}

	double bottom() {
		return Math.max(begin * uy, end * uy) + reach * Math.abs(ux);
	}

	/**
	 * Cuts the strip with a row.
	 *
	 * @param dy the row, from the link's start
	 * @return whether they meet, from {@link #low()} to {@link #high()}
	 */
	boolean cut(final double dy) {
		low = Double.NEGATIVE_INFINITY;
		high = Double.POSITIVE_INFINITY;
		narrow(ux, begin - dy * uy, end - dy * uy);
		narrow(uy, dy * ux - reach, dy * ux + reach);
		return low <= high;
	}

	/** Keeps the dx with from <= slope * dx <= to. */
	private void narrow(final double slope, final double from, final double to) {
		if (slope > PARALLEL) {
			low = Math.max(low, from / slope);
			high = Math.min(high, to / slope);
		} else if (slope < -PARALLEL) {
			low = Math.max(low, to / slope);
			high = Math.min(high, from / slope);
		} else if (from > 0 || to < 0)
			high = Double.NEGATIVE_INFINITY;
	}

	/** Smallest column, from the link's start. */
	double low() {
		return low;
	}

	/** Largest column, from the link's start. */
	double high() {
		return high;
	}
}
