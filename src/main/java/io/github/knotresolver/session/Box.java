package io.github.knotresolver.session;

import java.util.List;

import net.imglib2.RandomAccessibleInterval;
import net.imglib2.type.numeric.RealType;
import net.imglib2.view.Views;

import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.image.Binning;
import io.github.knotresolver.image.FrameEvidence;
import io.github.knotresolver.image.Pixels;

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

	/**
	 * @param frame of the movie
	 * @param binning edge of a working pixel in the movie's pixels
	 * @return this part of it, in working pixels; NaN where the frame has no value
	 */
	float[] of(final RandomAccessibleInterval<? extends RealType<?>> frame, final int binning) {
		final long left = frame.min(0) + (long) x * binning,
			top = frame.min(1) + (long) y * binning;
		final double[] values = Pixels.doubles(Views.interval(frame, new long[]{left, top},
			new long[]{left + (long) width * binning - 1, top + (long) height * binning - 1}));
		final float[] pixels = new float[values.length];
		for (int i = 0; i < pixels.length; i++)
			pixels[i] = (float) values[i];
		return Binning.mean(pixels, width * binning, binning);
	}
}
