package io.github.knotresolver.session;

import java.util.Arrays;
import java.util.List;
import java.util.function.Function;

import net.imglib2.RandomAccessibleInterval;
import net.imglib2.type.numeric.RealType;
import net.imglib2.view.Views;

import io.github.knotresolver.image.Background;
import io.github.knotresolver.image.LineAppearance;
import io.github.knotresolver.image.Pixels;
import io.github.knotresolver.image.RoundSpots;
import io.github.knotresolver.image.StillPicture;
import io.github.knotresolver.image.StuckPixels;
import io.github.knotresolver.model.Movie;
import io.github.knotresolver.progress.Cancellation;
import io.github.knotresolver.skeleton.AppearanceFinder;

/**
 * Takes what stays where it is in all frames off a movie before anything is looked for in it: the
 * camera's hot pixels are filled in from around them, the light of round bright spots, beads and
 * dirt, is taken off. What its lines look like is found out once more without them.
 *
 * @param movie the movie without them; as it was if there are none
 * @param lines what its lines look like
 * @param count how many spots there are
 * @param hot how many hot pixels
 */
record StillSpots(Movie movie, AppearanceFinder.Found lines, int count, int hot) {

	/** Values of all these frames that are looked at together. */
	private static final int VALUES = 1 << 23;

	/**
	 * O(pixels of 32 frames).
	 *
	 * @param frames 1-based numbers of the frames, in order
	 * @param found what the movie's lines look like with the spots
	 * @param again finds out what the lines of a movie look like
	 */
	static StillSpots off(final Movie movie, final List<Integer> frames,
		final AppearanceFinder.Found found, final Function<Movie, AppearanceFinder.Found> again) {
		final StillSpots none = new StillSpots(movie, found, 0, 0);
		if (frames.size() < 2 || !found.appearance().hasReference())
			return none;
		final float[] still = still(movie,
			Arrays.stream(StillPicture.looks(frames.size(), SessionTuning.STILL_FRAMES))
				.map(frames::get).toArray(),
			found.appearance().polarity().sign());
		final StuckPixels hot = StuckPixels.in(still, movie.width(),
			SessionTuning.HOT * found.appearance().strand());
		final StillSpots filled = hot.count() == 0 ? none : none.filled(hot, again);
		if (frames.size() < SessionTuning.FEWEST_STILL_FRAMES)
			return filled;
		return filled.withoutSpots(hot.filled(still), again);
	}

	private StillSpots filled(final StuckPixels pixels,
		final Function<Movie, AppearanceFinder.Found> again) {
		final Movie filled = new Movie(movie.name(), FilledFrames.of(movie.frames(), pixels),
			movie.calibration());
		final AppearanceFinder.Found better = again.apply(filled);
		return better.appearance().hasReference()
			? new StillSpots(filled, better, 0, pixels.count())
			: this;
	}

	private StillSpots withoutSpots(final float[] still,
		final Function<Movie, AppearanceFinder.Found> again) {
		final RoundSpots.Found first = spots(still, movie.width(), lines.appearance());
		if (first.count() == 0)
			return this;
		final AppearanceFinder.Found better = again.apply(without(movie, first, lines));
		if (!better.appearance().hasReference())
			return this;
		final RoundSpots.Found spots = spots(still, movie.width(), better.appearance());
		return spots.count() == 0
			? this
			: new StillSpots(without(movie, spots, lines), better, spots.count(), hot);
	}

	private static RoundSpots.Found spots(final float[] still, final int width,
		final LineAppearance lines) {
		return RoundSpots.in(still, width, lines.sigma(), lines.strand());
	}

	/** Above its background; as many rows at a time as memory has room for. */
	private static float[] still(final Movie movie, final int[] frames, final int sign) {
		final float[] still = new float[movie.width() * movie.height()];
		final int rows = Math.max(1, VALUES / frames.length / movie.width());
		for (int top = 0; top < movie.height(); top += rows) {
			Cancellation.check();
			final int first = top, last = Math.min(movie.height(), top + rows) - 1;
			final float[] part = StillPicture.of(Arrays.stream(frames)
				.mapToObj(f -> rows(movie.frame(f - 1), first, last, sign)).toList());
			System.arraycopy(part, 0, still, top * movie.width(), part.length);
		}
		final float[] background = Background.of(still, movie.width(), new boolean[still.length]);
		for (int i = 0; i < still.length; i++)
			still[i] -= background[i];
		return still;
	}

	private static float[] rows(final RandomAccessibleInterval<? extends RealType<?>> frame,
		final int first, final int last, final int sign) {
		final float[] values = Pixels
			.floats(Views.interval(frame, new long[]{frame.min(0), frame.min(1) + first},
				new long[]{frame.max(0), frame.min(1) + last}));
		for (int i = 0; i < values.length; i++)
			values[i] *= sign;
		return values;
	}

	private static Movie without(final Movie movie, final RoundSpots.Found found,
		final AppearanceFinder.Found lines) {
		return new Movie(movie.name(),
			new SpotlessFrames(movie, found.light(), lines.appearance()).frames(),
			movie.calibration());
	}
}
