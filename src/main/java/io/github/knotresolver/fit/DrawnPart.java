
package io.github.knotresolver.fit;

/**
 * The part of a frame in which chains are drawn: what is kept for its pixels is as large as
 * that, not as the frame. It grows when a chain comes that reaches farther. Not for several
 * threads at a time.
 */
final class DrawnPart {

	/** Chains may move so far (pixels) before it grows. */
	private static final int ROOM = 12;

	private final NormalizedFrame frame;
	private NormalizedFrame view;
	private Patch patch = new Patch(0, 0, 0, 0);

	/** Around the nodes of the chain that was asked for last. */
	private double left, right, top, bottom;

	DrawnPart(final NormalizedFrame frame) {
		this.frame = frame;
		view = frame;
	}

	/**
	 * Makes sure that a chain lies inside, as far as it lies in the frame.
	 *
	 * @param x columns of its nodes
	 * @param y rows of its nodes
	 * @param links one less than it has nodes
	 * @param reach of its light in pixels
	 * @return whether the part has changed: then all that was kept for its pixels is void
	 */
	boolean grow(final double[] x, final double[] y, final int links, final double reach) {
		// A corner of a strip along a link is farther away than its sides.
		bound(x, y, links, Math.sqrt(2) * reach + 1);
		if (!isSomewhere())
			return false;
		if (patch.width() > 0 && left(0) >= patch.left() && top(0) >= patch.top()
			&& right(0) < patch.left() + patch.width() && bottom(0) < patch.top() + patch.height())
			return false;
		int x0 = left(ROOM), y0 = top(ROOM), x1 = right(ROOM), y1 = bottom(ROOM);
		if (patch.width() > 0) {
			x0 = Math.min(x0, patch.left());
			y0 = Math.min(y0, patch.top());
			x1 = Math.max(x1, patch.left() + patch.width() - 1);
			y1 = Math.max(y1, patch.top() + patch.height() - 1);
		}
		patch = new Patch(x0, y0, x1 - x0 + 1, y1 - y0 + 1);
		view = frame.window(x0, y0, patch.width(), patch.height());
		return true;
	}

	private void bound(final double[] x, final double[] y, final int links, final double margin) {
		left = Double.POSITIVE_INFINITY;
		top = left;
		right = -left;
		bottom = -left;
		for (int i = 0; i <= links; i++) {
			left = Math.min(left, x[i] - margin);
			right = Math.max(right, x[i] + margin);
			top = Math.min(top, y[i] - margin);
			bottom = Math.max(bottom, y[i] + margin);
		}
	}

	private int left(final int room) {
		return inside(Math.floor(left - room), frame.width());
	}

	private int right(final int room) {
		return inside(Math.ceil(right + room), frame.width());
	}

	private int top(final int room) {
		return inside(Math.floor(top - room), frame.height());
	}

	private int bottom(final int room) {
		return inside(Math.ceil(bottom + room), frame.height());
	}

	private static int inside(final double at, final int size) {
		return (int) Math.max(0, Math.min(size - 1, at));
	}

	/** @return whether the chain that was asked for last has a place at all */
	boolean isSomewhere() {
		return Double.isFinite(left + right + top + bottom);
	}

	/** @return where it is in the frame */
	Patch patch() {
		return patch;
	}

	/** @return its pixels */
	NormalizedFrame view() {
		return view;
	}
}
