package io.github.knotresolver.pipeline;

import java.util.List;

import net.imglib2.img.Img;
import net.imglib2.type.logic.BitType;

import io.github.knotresolver.model.Movie;
import io.github.knotresolver.model.Settings;
import io.github.knotresolver.model.UserException;
import io.github.knotresolver.progress.Progress;
import io.github.knotresolver.progress.Workers;
import io.github.knotresolver.skeleton.Skeletonize;

/**
 * How far segmentation alone gets: the skeletons of all objects, before anything
 * is resolved. The published evaluation judges its baselines by them.
 */
public final class FrameSkeletons {

	private FrameSkeletons() {
	}

	/**
	 * Cleans, segments and thins the frames that the parameters ask for.
	 *
	 * @param movie the movie; only read
	 * @param parameters how; candidates and resolver have no say but for the
	 *          automatic threshold, which is Otsu's in the published method
	 * @param progress told how far the work is; may cancel
	 * @return a one-pixel line for each wanted frame, in order, of a frame's size
	 * @throws UserException if the movie and the parameters do not fit
	 *           together
	 */
	public static List<Img<BitType>> of(final Movie movie, final Settings parameters,
		final Progress progress) {
		final List<Integer> wanted = new FrameChoice(movie, parameters).frames();
		try (Workers workers = new Workers(parameters.threads())) {
			final List<Img<BitType>> masks = new FramePreparer(movie, parameters).masks(wanted,
				workers, progress);
			return workers.map("Thinning", progress, masks.size(),
				i -> Skeletonize.thin(masks.get(i)));
		}
	}
}
