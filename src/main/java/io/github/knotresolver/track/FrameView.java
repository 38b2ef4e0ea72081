package io.github.knotresolver.track;

import net.imglib2.img.Img;
import net.imglib2.type.logic.BitType;

import io.github.knotresolver.fit.NormalizedFrame;
import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.graph.Segment;
import io.github.knotresolver.graph.SkeletonGraph;

/**
 * A frame as the fit sees it.
 *
 * @param frame 1-based number of the frame in the movie
 * @param light the pixels, background at 0
 * @param mask all objects
 * @param graph the graph of their skeletons
 */
public record FrameView(int frame, NormalizedFrame light, Img<BitType> mask, SkeletonGraph graph) {

	/**
	 * @param place in pixels
	 * @return the distance to the nearest skeleton in pixels; infinite if there is none
	 */
	public double distance(final Point place) {
		double nearest = Double.POSITIVE_INFINITY;
		for (final Segment segment : graph.segments())
			for (int i = 0; i < segment.curve().size(); i++)
				nearest = Math.min(nearest, segment.curve().point(i).distanceTo(place));
		return nearest;
	}

	/**
	 * @param amplitude the brightness that becomes 1
	 * @return the same frame with its light in other units
	 */
	FrameView scaled(final double amplitude) {
		return amplitude == 1
			? this
			: new FrameView(frame, light.rescaled(0, amplitude), mask, graph);
	}

	/**
	 * @param background the value that becomes 0
	 * @param amplitude the brightness above it that becomes 1
	 * @return the same frame with its light in other units
	 */
	FrameView rescaled(final double background, final double amplitude) {
		return new FrameView(frame, light.rescaled(background, amplitude), mask, graph);
	}

	/**
	 * @param sigma of a Gaussian in pixels, above 0
	 * @return the same frame with blurred light
	 */
	FrameView blurred(final double sigma) {
		return new FrameView(frame, light.blurred(sigma), mask, graph);
	}
}
