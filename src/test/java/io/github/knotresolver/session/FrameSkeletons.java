package io.github.knotresolver.session;

import java.util.List;

import net.imglib2.img.Img;
import net.imglib2.type.logic.BitType;

import io.github.knotresolver.image.FrameEvidence;
import io.github.knotresolver.image.Pixels;
import io.github.knotresolver.model.Movie;
import io.github.knotresolver.model.Segmentation;
import io.github.knotresolver.model.Settings;
import io.github.knotresolver.model.UserException;
import io.github.knotresolver.progress.Progress;
import io.github.knotresolver.progress.Workers;
import io.github.knotresolver.skeleton.AppearanceFinder;
import io.github.knotresolver.skeleton.EvidenceFinder;
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
	 * @param parameters how; candidates and resolver only decide the
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
			if (parameters.segmentation().steps() == Segmentation.Steps.EVIDENCE)
				return evidence(movie, parameters, wanted, workers, progress);
			final Movie bright = PreparedMovie.bright(movie, parameters, wanted, workers, progress);
			final List<Img<BitType>> masks = new FramePreparer(bright, parameters).masks(wanted,
				workers, progress);
			return workers.map("Thinning", progress, masks.size(),
				i -> Skeletonize.thin(masks.get(i)));
		}
	}

	private static List<Img<BitType>> evidence(final Movie movie, final Settings parameters,
		final List<Integer> wanted, final Workers workers, final Progress progress) {
		final EvidenceFinder finder = new EvidenceFinder(new AppearanceFinder(workers, progress)
			.find(movie, wanted, parameters.segmentation().polarity()).appearance());
		return workers.map("Finding lines", progress, wanted.size(),
			i -> enlarged(finder.find(movie.frame(wanted.get(i) - 1)), movie));
	}

	/** The skeleton in the movie's pixels. */
	private static Img<BitType> enlarged(final FrameEvidence evidence, final Movie movie) {
		final int factor = evidence.appearance().binning();
		if (factor == 1)
			return evidence.skeleton();
		final boolean[] small = Pixels.bits(evidence.skeleton());
		final boolean[] large = new boolean[movie.width() * movie.height()];
		for (int y = 0; y < evidence.height() * factor; y++)
			for (int x = 0; x < evidence.width() * factor; x++)
				large[y * movie.width() + x] = small[y / factor * evidence.width() + x / factor];
		return Skeletonize.thin(Pixels.mask(large, movie.width()));
	}
}
