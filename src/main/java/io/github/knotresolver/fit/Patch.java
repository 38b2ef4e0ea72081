
package io.github.knotresolver.fit;

import java.util.List;

/** A rectangle of a picture that holds chains and what is around them. */
record Patch(int left, int top, int width, int height) {

	/**
	 * @param chains at least one
	 * @param margin around their nodes, in pixels
	 * @param frame the picture; the patch lies in it and has at least one pixel
	 */
	static Patch around(final List<Chain> chains, final double margin,
		final NormalizedFrame frame) {
		double left = Double.POSITIVE_INFINITY, top = left, right = -left, bottom = -left;
		for (final Chain chain : chains) {
			final double[] x = new double[chain.links() + 1], y = new double[chain.links() + 1];
			chain.nodes(x, y);
			for (int i = 0; i < x.length; i++) {
				left = Math.min(left, x[i]);
				right = Math.max(right, x[i]);
				top = Math.min(top, y[i]);
				bottom = Math.max(bottom, y[i]);
			}
		}
		final int x0 = inside(Math.floor(left - margin), frame.width());
		final int y0 = inside(Math.floor(top - margin), frame.height());
		return new Patch(x0, y0, inside(Math.ceil(right + margin), frame.width()) - x0 + 1,
			inside(Math.ceil(bottom + margin), frame.height()) - y0 + 1);
	}

	private static int inside(final double at, final int size) {
		return (int) Math.max(0, Math.min(size - 1, at));
	}

	boolean meets(final Patch other) {
		return left < other.left + other.width && other.left < left + width
			&& top < other.top + other.height && other.top < top + height;
	}

	/** The pixels of a picture of {@code stride} columns within this patch, row by row. */
	double[] cut(final double[] picture, final int stride) {
		final double[] part = new double[width * height];
		for (int row = 0; row < height; row++)
			System.arraycopy(picture, (top + row) * stride + left, part, row * width, width);
		return part;
	}
}
