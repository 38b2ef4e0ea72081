package io.github.knotresolver.skeleton;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;

import io.github.knotresolver.geometry.RobustStatistics;
import io.github.knotresolver.image.CrossProfile;
import io.github.knotresolver.image.Enlargement;
import io.github.knotresolver.image.HotPixels;
import io.github.knotresolver.image.LineAppearance;
import io.github.knotresolver.image.LineVote;
import io.github.knotresolver.image.Pixels;
import io.github.knotresolver.image.Ridges;
import io.github.knotresolver.model.Movie;
import io.github.knotresolver.model.Polarity;
import io.github.knotresolver.progress.Progress;
import io.github.knotresolver.progress.Workers;

/**
 * Finds out once for a movie what its lines look like: bright or dark, how wide, how
 * strong. Looks at four to eight frames.
 */
public final class AppearanceFinder {

	private final Workers workers;
	private final Progress progress;

	/**
	 * @param workers threads
	 * @param progress told how far it is, and asked whether to stop
	 */
	public AppearanceFinder(final Workers workers, final Progress progress) {
		this.workers = workers;
		this.progress = progress;
	}

	/**
	 * What was found.
	 *
	 * @param appearance what the lines look like; its reference is NaN if there are none
	 * @param doubtful whether lines of the other sign are nearly as strong
	 * @param enlargement whether the movie was blown up
	 */
	public record Found(LineAppearance appearance, boolean doubtful, Enlargement enlargement) {
	}

	/** Frames without hot pixels, and the columns of a row. */
	private record Sample(List<float[]> frames, int width) {

		/** The same frames, but only the part around what was found. */
		Sample around(final List<Look> looks, final int binning) {
			final int height = frames.get(0).length / width;
			int left = width, right = 0, top = height, bottom = 0;
			for (final Look look : looks)
				for (final int at : look.places) {
					final int x = at % (width / binning) * binning,
						y = at / (width / binning) * binning;
					left = Math.min(left, x);
					right = Math.max(right, x + binning);
					top = Math.min(top, y);
					bottom = Math.max(bottom, y + binning);
				}
			if (left > right)
				return this;
			final int x = Math.max(0, left - SkeletonTuning.LOOK_MARGIN),
				y = Math.max(0, top - SkeletonTuning.LOOK_MARGIN);
			final int columns = Math.min(width, right + SkeletonTuning.LOOK_MARGIN) - x;
			final int rows = Math.min(height, bottom + SkeletonTuning.LOOK_MARGIN) - y;
			return new Sample(
				frames.stream().map(frame -> part(frame, y * width + x, columns, rows)).toList(),
				columns);
		}

		private float[] part(final float[] frame, final int from, final int columns,
			final int rows) {
			final float[] part = new float[columns * rows];
			for (int row = 0; row < rows; row++)
				System.arraycopy(frame, from + row * width, part, row * columns, columns);
			return part;
		}
	}

	/** What one frame says. */
	private record Look(double[] profile, double clarity, double strength, int[] places) {
	}

	/**
	 * Looks at a movie.
	 *
	 * @param movie the movie
	 * @param frames 1-based numbers of the frames that may be looked at, at least one
	 * @param polarity bright or dark, or auto to find it
	 * @return what its lines look like
	 */
	public Found find(final Movie movie, final List<Integer> frames, final Polarity polarity) {
		final List<float[]> calm = calm(movie, frames);
		final LineVote vote = LineVote.of(calm, movie.width(), workers, progress);
		final Polarity sign = polarity == Polarity.AUTO ? vote.polarity() : polarity;
		return new Found(
			measured(LineAppearance.of(sign, vote.sigma(sign)), new Sample(calm, movie.width())),
			polarity == Polarity.AUTO && vote.isDoubtful(sign), Enlargement
				.of(Pixels.floats(movie.frame(frames.get(frames.size() / 2) - 1)), movie.width()));
	}

	/**
	 * @param movie the movie
	 * @param frames 1-based numbers of the frames that may be looked at, at least one
	 * @return bright or dark
	 */
	public Polarity polarity(final Movie movie, final List<Integer> frames) {
		return LineVote.of(calm(movie, frames), movie.width(), workers, progress).polarity();
	}

	private List<float[]> calm(final Movie movie, final List<Integer> frames) {
		progress.report("Looking at the movie", 0);
		final List<Integer> few = spread(frames, movie.width() * movie.height());
		return workers.map(few.size(),
			i -> HotPixels.clip(Pixels.floats(movie.frame(few.get(i) - 1)), movie.width()));
	}

	private static List<Integer> spread(final List<Integer> frames, final int pixels) {
		final int count = Math.min(frames.size(), Math.max(SkeletonTuning.FEWEST_LOOKS,
			Math.min(SkeletonTuning.MOST_LOOKS, (int) (SkeletonTuning.LOOKED_AT / pixels))));
		return IntStream.range(0, count).mapToObj(
			i -> frames.get(count == 1 ? 0 : (int) ((long) i * (frames.size() - 1) / (count - 1))))
			.toList();
	}

	/** Looks at the whole frames once, then at the part where something was found. */
	private LineAppearance measured(final LineAppearance rough, final Sample whole) {
		final List<Look> first = looks(whole, rough);
		final Sample sample = whole.around(first, rough.binning());
		LineAppearance appearance = withWidth(rough, first);
		for (int round = 1; round < SkeletonTuning.WIDTH_ROUNDS; round++)
			appearance = withWidth(appearance, looks(sample, appearance));
		List<Look> last = looks(sample, appearance);
		final LineAppearance finer = appearance.finer();
		if (finer.binning() != appearance.binning()) {
			final List<Look> closer = looks(sample, finer);
			if (focusWanders(last) || isBlunt(closer)) {
				appearance = finer;
				last = closer;
			}
		}
		final double[] clarities = last.stream().mapToDouble(Look::clarity).filter(c -> c > 0)
			.toArray();
		if (clarities.length == 0)
			return appearance;
		appearance = appearance.asFineAsNoiseAllows(RobustStatistics.median(clarities, 0));
		final double[] strengths = looks(sample, appearance).stream().mapToDouble(Look::strength)
			.filter(s -> s > 0).toArray();
		return strengths.length == 0
			? appearance
			: appearance.withReference(RobustStatistics.median(strengths));
	}

	/** Whether lines are cut off, or their light does not add up: then they look wider than they are. */
	private static boolean isBlunt(final List<Look> looks) {
		return CrossProfile
			.bluntness(looks.stream().map(Look::profile).toList()) > SkeletonTuning.BLUNT;
	}

	/** Whether lines are much wider in some frames than in others; of many the extremes may be noise. */
	private static boolean focusWanders(final List<Look> looks) {
		final double[] widths = looks.stream()
			.mapToDouble(l -> CrossProfile.width(List.of(l.profile))).filter(Double::isFinite)
			.sorted().toArray();
		final int extreme = widths.length / SkeletonTuning.MANY_LOOKS;
		return widths.length > 0
			&& widths[widths.length - 1 - extreme] > SkeletonTuning.WANDERS * widths[extreme];
	}

	private static LineAppearance withWidth(final LineAppearance before, final List<Look> looks) {
		final double width = CrossProfile.width(looks.stream().map(Look::profile).toList());
		if (Double.isNaN(width))
			return before;
		final double factor = Math.min(
			Math.max(width / LineAppearance.FULL_WIDTH, SkeletonTuning.MOST_NARROWING),
			SkeletonTuning.MOST_WIDENING);
		return LineAppearance.of(before.polarity(), factor * before.sigma());
	}

	private List<Look> looks(final Sample sample, final LineAppearance appearance) {
		return workers.map(sample.frames.size(), t -> {
			progress.checkCancelled();
			return look(Ridges.of(sample.frames.get(t), sample.width, appearance));
		});
	}

	private static Look look(final Ridges ridges) {
		final LinePixels line = new EvidenceFinder(ridges.appearance()).lines(ridges);
		final List<int[]> parts = new ArrayList<>(LineParts.of(line));
		int[] longest = {};
		for (final int[] part : parts)
			if (part.length > longest.length)
				longest = part;
		final int[] all = EvidenceFinder.inside(line, line.pixels());
		final double[] clarity = Arrays.stream(all).mapToDouble(ridges::z).toArray(),
			strength = Arrays.stream(EvidenceFinder.inside(line, longest))
				.mapToDouble(ridges::strength).toArray();
		return new Look(CrossProfile.of(ridges, all), RobustStatistics.median(clarity, 0),
			RobustStatistics.median(strength, 0), all);
	}
}
