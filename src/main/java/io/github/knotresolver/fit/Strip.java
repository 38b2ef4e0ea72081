package io.github.knotresolver.fit;

/**
 * A rectangle along a link, row by row, as far as it is inside a part of a frame: the pixels that
 * can matter for the link, without those in the corners of its bounding box.
 */
final class Strip {

	private static final double PARALLEL = 1e-9;

	private Patch part = new Patch(0, 0, 0, 0);

	private double x0;
	private double y0;
	private double ux;
	private double uy;
	private double begin;
	private double end;
	private double reach;

	private double low;
	private double high;

	/** Strips to come are cut off where this part of a frame ends. */
	void within(final Patch patch) {
		part = patch;
	}

	/**
	 * Lays the strip.
	 *
	 * @param x column of the link's start
	 * @param y row of the link's start
	 * @param unitX direction of the link, a unit vector
	 * @param unitY direction of the link
	 * @param from along the link, in pixels from its start, usually negative
	 * @param to along the link, in pixels from its start
	 * @param across half width across the link in pixels
	 */
	void lay(final double x, final double y, final double unitX, final double unitY,
		final double from, final double to, final double across) {
		x0 = x;
		y0 = y;
		ux = unitX;
		uy = unitY;
		begin = from;
		end = to;
		reach = across;
	}

	int firstRow() {
		final double top = Math.min(begin * uy, end * uy) - reach * Math.abs(ux);
		return Math.max(part.top(), (int) Math.ceil(y0 + top));
	}

	int lastRow() {
		final double bottom = Math.max(begin * uy, end * uy) + reach * Math.abs(ux);
		return Math.min(part.top() + part.height() - 1, (int) Math.floor(y0 + bottom));
	}

	/** Cuts the strip with a row: then first and last column are those of that row. */
	void cut(final int row) {
		final double dy = row - y0;
		low = Double.NEGATIVE_INFINITY;
		high = Double.POSITIVE_INFINITY;
		narrow(ux, begin - dy * uy, end - dy * uy);
		narrow(uy, dy * ux - reach, dy * ux + reach);
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

	int firstColumn() {
		return Math.max(part.left(), (int) Math.ceil(x0 + low));
	}

	/** Before the first column if row and strip do not meet. */
	int lastColumn() {
		return Math.min(part.left() + part.width() - 1, (int) Math.floor(x0 + high));
	}
}
