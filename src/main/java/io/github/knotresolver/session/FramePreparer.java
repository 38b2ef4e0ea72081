package io.github.knotresolver.session;

import java.util.AbstractList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;

import net.imglib2.RandomAccessibleInterval;
import net.imglib2.img.Img;
import net.imglib2.type.logic.BitType;
import net.imglib2.type.numeric.real.FloatType;

import org.apache.commons.math3.stat.descriptive.rank.Median;

import io.github.knotresolver.fit.NormalizedFrame;
import io.github.knotresolver.geometry.RobustStatistics;
import io.github.knotresolver.graph.SkeletonGraph;
import io.github.knotresolver.image.ContrastStretch;
import io.github.knotresolver.image.FrameCleaner;
import io.github.knotresolver.image.GaussianBlur;
import io.github.knotresolver.image.PixelNoise;
import io.github.knotresolver.image.Pixels;
import io.github.knotresolver.mask.FilamentSegmenter;
import io.github.knotresolver.mask.LocalThreshold;
import io.github.knotresolver.model.Movie;
import io.github.knotresolver.model.Segmentation;
import io.github.knotresolver.model.Settings;
import io.github.knotresolver.progress.Progress;
import io.github.knotresolver.progress.Workers;
import io.github.knotresolver.skeleton.Skeletonize;
import io.github.knotresolver.track.FrameView;

/** Walks frames from their pixels to the graphs of their skeletons. */
final class FramePreparer {

	private final Movie movie;
	private final FrameCleaner cleaner;
	private final boolean blurs;
	private final Segmentation.Steps steps;
	private final FilamentSegmenter segmenter;

	/**
	 * @param movie its lines are bright
	 * @param parameters with steps other than evidence
	 */
	FramePreparer(final Movie movie, final Settings parameters) {
		this(movie, parameters, !parameters.isPublished() && isNoisy(movie));
	}

	/** The same for one who knows whether the movie is to be blurred, which the published method never does. */
	FramePreparer(final Movie movie, final Settings parameters, final boolean blurs) {
		this.movie = movie;
		cleaner = new FrameCleaner(parameters.cleaning());
		this.blurs = blurs;
		steps = parameters.segmentation().steps();
		segmenter = parameters.isPublished()
			? new FilamentSegmenter(parameters.segmentation())
			: new FilamentSegmenter(parameters.segmentation(), new LocalThreshold());
	}

	/** @param frames 1-based numbers of the frames, in order */
	List<FrameView> prepare(final List<Integer> frames, final Workers workers,
		final Progress progress) {
		final List<Img<BitType>> masks = masks(frames, workers, progress);
		return workers.map("Thinning", progress, frames.size(),
			i -> view(frames.get(i), masks.get(i)));
	}

	/** @param frames 1-based numbers of the frames, in order */
	List<Img<BitType>> masks(final List<Integer> frames, final Workers workers,
		final Progress progress) {
		return steps == Segmentation.Steps.ACTIVE_CONTOUR
			? carried(frames, progress)
			: workers.map("Segmenting", progress, frames.size(),
				i -> segmenter.segment(clean(frames.get(i))));
	}

	/** One frame's mask is the next one's start. */
	private List<Img<BitType>> carried(final List<Integer> frames, final Progress progress) {
		return segmenter.segmentByContourAlone(new AbstractList<>() {

			@Override
			public RandomAccessibleInterval<FloatType> get(final int i) {
				return clean(frames.get(i));
			}

			@Override
			public int size() {
				return frames.size();
			}
		}, progress);
	}

	private FrameView view(final int frame, final Img<BitType> mask) {
		return new FrameView(frame, light(frame), mask, SkeletonGraph.of(Skeletonize.thin(mask)));
	}

	/** @return a frame as the threshold sees it, 0..1 */
	Img<FloatType> clean(final int frame) {
		final Img<FloatType> clean = cleaner.clean(movie.frame(frame - 1));
		return blurs
			? Pixels.image(
				GaussianBlur.blur(Pixels.floats(clean), movie.width(), SessionTuning.CALM_FRAME),
				movie.width())
			: clean;
	}

	/** Whether single pixels say little: looks at a few frames of the movie. */
	static boolean isNoisy(final Movie movie) {
		final int stride = 1 + (movie.size() - 1) / SessionTuning.NOISE_FRAMES;
		final double[] noise = IntStream.range(0, movie.size()).filter(t -> t % stride == 0)
			.mapToDouble(t -> PixelNoise.of(
				Pixels.doubles(ContrastStretch.saturate(movie.frame(t),
					FrameCleaner.SATURATED_PERCENT, FrameCleaner.SATURATED_PERCENT)),
				movie.width()))
			.toArray();
		return new Median().evaluate(noise) > SessionTuning.NOISY_FRAME;
	}

	/** The frame above its background; pixels without a value are taken for background. */
	NormalizedFrame light(final int frame) {
		final double[] pixels = Pixels.doubles(movie.frame(frame - 1));
		final double background = RobustStatistics
			.upperMedian(Arrays.stream(pixels).filter(Double::isFinite).toArray(), 0);
		for (int i = 0; i < pixels.length; i++)
			pixels[i] = Double.isFinite(pixels[i]) ? pixels[i] - background : 0;
		return new NormalizedFrame(movie.width(), movie.height(), pixels);
	}
}
