package io.github.knotresolver.track;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.function.IntToDoubleFunction;

import net.imglib2.img.Img;
import net.imglib2.type.logic.BitType;

import io.github.knotresolver.Drawn;
import io.github.knotresolver.fit.Chain;
import io.github.knotresolver.fit.DrawnMovie;
import io.github.knotresolver.fit.LineModel;
import io.github.knotresolver.fit.LineTables;
import io.github.knotresolver.fit.NormalizedFrame;
import io.github.knotresolver.fit.Scene;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.graph.SkeletonGraph;
import io.github.knotresolver.image.FrameCleaner;
import io.github.knotresolver.image.Pixels;
import io.github.knotresolver.mask.FilamentSegmenter;
import io.github.knotresolver.model.Cleaning;
import io.github.knotresolver.model.Segmentation;
import io.github.knotresolver.skeleton.Skeletonize;

/** Drawn movies as the tracking sees them. */
final class DrawnFrames {

	private static final double BACKGROUND = 40;

	private DrawnFrames() {
	}

	/**
	 * @param chains the filament in each frame
	 * @param line what it looks like
	 * @param fading brightness of each frame, by 0-based index, relative to the first
	 * @return the frames, the light above the background
	 */
	static List<FrameView> of(final List<Chain> chains, final LineModel line,
		final IntToDoubleFunction fading) {
		final DrawnMovie drawn = DrawnMovie.draw(chains, List.of(), line, 0.04, 4);
		final List<FrameView> frames = new ArrayList<>();
		for (int t = 0; t < chains.size(); t++) {
			final Img<BitType> mask = new FilamentSegmenter(Segmentation.DEFAULT)
				.segment(new FrameCleaner(Cleaning.DEFAULT).clean(drawn.movie().frame(t)));
			final NormalizedFrame light = new NormalizedFrame(DrawnMovie.SIZE, DrawnMovie.SIZE,
				Pixels.doubles(drawn.movie().frame(t)))
				.rescaled(BACKGROUND, 1 / fading.applyAsDouble(t));
			frames.add(new FrameView(t + 1, light, mask, SkeletonGraph.of(Skeletonize.thin(mask))));
		}
		return frames;
	}

	/**
	 * @param size of the frame in pixels, across and down
	 * @return the light of chains in strands, row by row, over a dark background
	 */
	static double[] light(final int size, final LineTables line, final List<Chain> chains) {
		return new Scene(new NormalizedFrame(size, size, new double[size * size]), line, chains)
			.picture();
	}

	/**
	 * A square frame of which the lines are known; its mask is what is nearly half as bright as a
	 * strand.
	 *
	 * @param frame its 1-based number
	 * @param light in strands, row by row
	 * @param noise of a pixel in strands
	 * @param random of the noise
	 */
	static FrameView lit(final int frame, final double[] light, final double noise,
		final Random random) {
		final int size = (int) Math.sqrt(light.length);
		final boolean[] bright = new boolean[light.length];
		final double[] noisy = new double[light.length];
		for (int i = 0; i < light.length; i++) {
			bright[i] = light[i] > 0.45;
			noisy[i] = noise * random.nextGaussian() + light[i];
		}
		final Img<BitType> mask = Pixels.mask(bright, size);
		return new FrameView(frame, new NormalizedFrame(size, size, noisy), mask,
			SkeletonGraph.of(Skeletonize.thin(mask)));
	}

	/**
	 * @param curves what is seen, as lines one pixel wide
	 * @return one frame of 130 by 110 pixels
	 */
	static FrameView lines(final int frame, final Polyline... curves) {
		final int width = 130, height = 110;
		final Img<BitType> skeleton = Drawn.skeleton(width, height, curves);
		return new FrameView(frame, new NormalizedFrame(width, height, Pixels.doubles(skeleton)),
			skeleton, SkeletonGraph.of(skeleton));
	}
}
