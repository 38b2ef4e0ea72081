package io.github.knotresolver.track;

import net.imglib2.img.Img;
import net.imglib2.type.logic.BitType;

import io.github.knotresolver.fit.NormalizedFrame;
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
	 * @param amplitude the brightness that becomes 1
	 * @return the same frame with its light in other units
	 */
	FrameView scaled(final double amplitude) {
		return new FrameView(frame, light.rescaled(0, amplitude), mask, graph);
	}
}
