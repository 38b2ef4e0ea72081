package io.github.knotresolver.session;

import java.util.List;

import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.image.FrameEvidence;

/** A part of all frames, in working pixels. */
record Box(int x, int y, int width, int height) {

	/**
	 * @param evidence at least one frame
	 * @param told places that must be inside as far as the frame has them
	 * @param margin around what was found, in working pixels
	 * @return the box around all lines of all frames; the frame if there are none
	 */
	static Box around(final List<FrameEvidence> evidence, final List<Point> told,
		final int margin) {
		final int width = evidence.get(0).width(), height = evidence.get(0).height();
		double left = width, right = 0, top = height, bottom = 0;
		for (final FrameEvidence e : evidence)
			for (int i = 0; i < e.size(); i++) {
				left = Math.min(left, e.x(i));
				right = Math.max(right, e.x(i));
				top = Math.min(top, e.y(i));
				bottom = Math.max(bottom, e.y(i));
			}
		if (left > right)
			return new Box(0, 0, width, height);
		for (final Point p : told) {
			left = Math.min(left, p.x());
			right = Math.max(right, p.x());
			top = Math.min(top, p.y());
			bottom = Math.max(bottom, p.y());
		}
		final int x = (int) Math.max(0, Math.floor(left) - margin);
		final int y = (int) Math.max(0, Math.floor(top) - margin);
		return new Box(x, y, (int) Math.min(width, Math.ceil(right) + margin + 1) - x,
			(int) Math.min(height, Math.ceil(bottom) + margin + 1) - y);
	}

	/** @return this part of a frame of rows of the given width */
	float[] of(final float[] pixels, final int rowWidth) {
		final float[] part = new float[width * height];
		for (int row = 0; row < height; row++)
			System.arraycopy(pixels, (y + row) * rowWidth + x, part, row * width, width);
		return part;
	}
}
