
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

	/** All of a picture. */
	static Patch of(final NormalizedFrame frame) {
		return new Patch(0, 0, frame.width(), frame.height());
	}

	/**
	 * @param at place of a pixel in another patch of the same picture, row by row
	 * @param other that patch
	 * @return its place in this one; -1 if it is outside
	 */
	int at(final int at, final Patch other) {
		final int x = at % other.width + other.left - left, y = at / other.width + other.top - top;
		return x < 0 || y < 0 || x >= width || y >= height ? -1 : y * width + x;
	}

	private static int inside(final double at, final int size) {
		return (int) Math.max(0, Math.min(size - 1, at));
	}

	/** This part of a frame. */
	NormalizedFrame part(final NormalizedFrame frame) {
		return frame.window(left, top, width, height);
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
