package io.github.knotresolver.track;

import java.util.Optional;
import java.util.function.Supplier;

import net.imglib2.img.Img;
import net.imglib2.type.logic.BitType;

import io.github.knotresolver.fit.NormalizedFrame;
import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.graph.Segment;
import io.github.knotresolver.graph.SkeletonGraph;
import io.github.knotresolver.image.FrameEvidence;

/**
 * A frame as the fit sees it.
 *
 * @param frame 1-based number of the frame in the movie
 * @param light the pixels, background at 0
 * @param masks makes the mask of all objects; kept small, made when it is looked at
 * @param graph the graph of their skeletons
 * @param evidence what is known of the lines beyond mask and graph, in the same pixels;
 *          empty if masks were made by thresholds
 */
public record FrameView(int frame, NormalizedFrame light, Supplier<Img<BitType>> masks,
	SkeletonGraph graph, Optional<FrameEvidence> evidence) {

	/**
	 * A frame whose mask was made by a threshold.
	 *
	 * @param frame 1-based number of the frame in the movie
	 * @param light the pixels, background at 0
	 * @param mask all objects
	 * @param graph the graph of their skeletons
	 */
	public FrameView(final int frame, final NormalizedFrame light, final Img<BitType> mask,
		final SkeletonGraph graph) {
		this(frame, light, () -> mask, graph, Optional.empty());
	}

	/**
	 * A frame as the evidence has it.
	 *
	 * @param frame 1-based number of the frame in the movie
	 * @param light the pixels, background at 0
	 * @param evidence what can be seen of lines
	 */
	public FrameView(final int frame, final NormalizedFrame light, final FrameEvidence evidence) {
		this(frame, light, evidence::mask, SkeletonGraph.of(evidence.skeleton()),
			Optional.of(evidence));
	}

	/** @return the mask of all objects; O(pixels), so ask once */
	public Img<BitType> mask() {
		return masks.get();
	}

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
			: new FrameView(frame, light.rescaled(0, amplitude), masks, graph, evidence);
	}

	/**
	 * @param background the value that becomes 0
	 * @param amplitude the brightness above it that becomes 1
	 * @return the same frame with its light in other units
	 */
	FrameView rescaled(final double background, final double amplitude) {
		return new FrameView(frame, light.rescaled(background, amplitude), masks, graph,
			Optional.empty());
	}

	/**
	 * @param widening how many times as wide as usual lines are
	 * @param brightness of a strand, which becomes 1
	 * @return the same frame of which it is known
	 */
	FrameView focused(final double widening, final double brightness) {
		return new FrameView(frame, light.rescaled(0, brightness).withWidening(widening), masks,
			graph, evidence);
	}

	/**
	 * @param ceiling for every pixel the brightness above which it was cut off
	 * @return the same frame of which it is known
	 */
	public FrameView withCeiling(final double[] ceiling) {
		return new FrameView(frame, light.withCeiling(ceiling), masks, graph, evidence);
	}

	/**
	 * @param sigma of a Gaussian in pixels, above 0
	 * @return the same frame with blurred light
	 */
	FrameView blurred(final double sigma) {
		return new FrameView(frame, light.blurred(sigma), masks, graph, evidence);
	}
}
