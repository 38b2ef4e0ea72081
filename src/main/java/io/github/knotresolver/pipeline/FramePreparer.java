package io.github.knotresolver.pipeline;

import java.util.Arrays;

import net.imglib2.img.Img;
import net.imglib2.type.logic.BitType;

import io.github.knotresolver.fit.NormalizedFrame;
import io.github.knotresolver.graph.SkeletonGraph;
import io.github.knotresolver.image.FrameCleaner;
import io.github.knotresolver.image.Movie;
import io.github.knotresolver.image.Pixels;
import io.github.knotresolver.mask.FilamentSegmenter;
import io.github.knotresolver.mask.LocalThreshold;
import io.github.knotresolver.skeleton.Skeletonize;
import io.github.knotresolver.track.FrameView;

/** Walks one frame from its pixels to the graph of its skeleton. */
final class FramePreparer {

	private final Movie movie;
	private final FrameCleaner cleaner;
	private final FilamentSegmenter segmenter;

	FramePreparer(final Movie movie, final Parameters parameters) {
		this.movie = movie;
		cleaner = new FrameCleaner(parameters.cleaning());
		segmenter = parameters.isPublished()
			? new FilamentSegmenter(parameters.segmentation())
			: new FilamentSegmenter(parameters.segmentation(), new LocalThreshold());
	}

	/** @param frame 1-based number of the frame */
	FrameView prepare(final int frame) {
		final Img<BitType> mask = mask(frame);
		return new FrameView(frame, light(frame), mask, SkeletonGraph.of(Skeletonize.thin(mask)));
	}

	Img<BitType> mask(final int frame) {
		return segmenter.segment(cleaner.clean(movie.frame(frame - 1)));
	}

	/** The frame above its background; pixels without a value are taken for background. */
	private NormalizedFrame light(final int frame) {
		final double[] pixels = Pixels.doubles(movie.frame(frame - 1));
		final double[] sorted = Arrays.stream(pixels).filter(Double::isFinite).sorted().toArray();
		final double background = sorted.length == 0 ? 0 : sorted[sorted.length / 2];
		for (int i = 0; i < pixels.length; i++)
			pixels[i] = Double.isFinite(pixels[i]) ? pixels[i] - background : 0;
		return new NormalizedFrame(movie.width(), movie.height(), pixels);
	}
}
