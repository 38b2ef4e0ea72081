package io.github.knotresolver.track;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import java.util.stream.Stream;

import io.github.knotresolver.fit.FilamentEstimate;
import io.github.knotresolver.geometry.RobustStatistics;
import io.github.knotresolver.track.OpenFrames.Seen;

/**
 * What open frames say about the filament's length. A frame in which an end is outside the
 * picture says only that the filament is at least as long as what is seen.
 *
 * @param whole lengths where both ends are in the picture, in order of time
 * @param longestCut longest piece that is seen where one is not; 0 if there is no such frame
 * @param cutShare share of the open frames in which an end is outside
 * @param changing the course of a length that changes
 */
record Lengths(double[] whole, double longestCut, double cutShare,
	Optional<LengthCourse> changing) {

	/** Standard error of a median of n values: so many MADs over the root of n. */
	private static final double MEDIAN_ERROR = RobustStatistics.MAD_TO_SD
		* RobustStatistics.MEDIAN_TO_MEAN_ERROR;

	static Lengths of(final OpenFrames open, final int frames, final boolean mayChange) {
		final List<Seen> seen = open.whole();
		final double[] whole = seen.stream().mapToDouble(s -> s.chain().length()).toArray();
		final double cut = open.seen().stream().filter(s -> !s.isWhole())
			.mapToDouble(s -> s.chain().length()).max().orElse(0);
		return new Lengths(whole, cut,
			open.seen().isEmpty() ? 0 : 1 - (double) whole.length / open.seen().size(),
			mayChange
				? LengthCourse.changing(seen.stream().mapToInt(Seen::index).toArray(), whole,
					frames)
				: Optional.empty());
	}

	/**
	 * Courses of a length that grows, shrinks or breaks, from contours that are as long as their
	 * light says. Where several filaments are taken for one, its length wanders: that is no course.
	 *
	 * @param free the movie as fitted with free lengths
	 * @param known what was known of the filament
	 * @return the same with the length as it was found; if that changes, first as frames say in which
	 *         the tip is free, since one that lies on the filament says little of where it ends
	 */
	static List<FilamentCourse> found(final FitTrellis.Solved free, final FilamentCourse known) {
		final int[] seen = IntStream.range(0, free.lengths().length)
			.filter(t -> free.looks().get(t).filter(FitLook::endsWithLight).isPresent()
				&& free.frames().get(t).visible() == 1)
			.toArray();
		final int[] open = Arrays.stream(seen)
			.filter(t -> GuessedLength.isTipFree(free.frames().get(t), known.estimate().model()))
			.toArray();
		return found(free, seen, known).stream()
			.flatMap(all -> Stream.concat(found(free, open, known).stream(), Stream.of(all)))
			.toList();
	}

	private static Optional<FilamentCourse> found(final FitTrellis.Solved free, final int[] seen,
		final FilamentCourse known) {
		final double[] whole = Arrays.stream(seen).mapToDouble(t -> free.lengths()[t]).toArray();
		final Lengths found = new Lengths(whole, 0, 0,
			LengthCourse.changing(seen, whole, free.lengths().length).filter(
				c -> c.kind() == LengthCourse.Kind.STEADY || c.kind() == LengthCourse.Kind.BROKEN));
		return found.changing
			.map(c -> known.withLength(c).withEstimate(found.settle(known.estimate())));
	}

	/** The course of the length, if it does not change, of a given length. */
	LengthCourse course(final double length, final int frames) {
		return changing.orElseGet(() -> LengthCourse.constant(length, frames));
	}

	/** An estimate with the longest length that the filament has. */
	FilamentEstimate settle(final FilamentEstimate estimate) {
		if (changing.isPresent())
			return estimate.withLength(
				Arrays.stream(changing.get().lengths()).max().orElse(estimate.length()),
				Double.NaN);
		if (cutShare <= TrackTuning.CUT_FRAMES && !Double.isNaN(estimate.lengthError()))
			return estimate;
		if (whole.length < TrackTuning.WHOLE_FRAMES)
			return estimate.withLength(Math.max(estimate.length(), longestCut), Double.NaN);
		return common(whole).map(c -> estimate.withLength(c.length, c.error)).orElse(estimate);
	}

	/**
	 * What lengths say together.
	 *
	 * @param length in pixels
	 * @param error its standard error in pixels
	 */
	record Common(double length, double error) {

		Common longer(final double by) {
			return new Common(length + by, error);
		}

		/**
		 * Whether it is noticeably not this one, and surely, or known far better.
		 *
		 * @param known in pixels
		 * @param uncertain standard error of that; NaN if it is not known
		 */
		boolean isOtherThan(final double known, final double uncertain) {
			final double off = Math.abs(length - known);
			return off > TrackTuning.NOTICEABLE_LENGTH * known
				&& (off > TrackTuning.SURELY_OTHER * error
					|| uncertain > TrackTuning.KNOWN_BETTER * error);
		}
	}

	/** Empty if they are too few, or as many are far too short as are far too long. */
	static Optional<Common> common(final double[] seen) {
		if (seen.length < TrackTuning.WHOLE_FRAMES)
			return Optional.empty();
		final double middle = RobustStatistics.median(seen);
		final double[] good = Arrays.stream(seen)
			.filter(l -> Math.abs(l / middle - 1) < TrackTuning.WHOLE_OUTLIER).toArray();
		if (good.length == 0)
			return Optional.empty();
		final double length = RobustStatistics.median(good);
		final double spread = RobustStatistics
			.median(Arrays.stream(good).map(l -> Math.abs(l - length)).toArray());
		return Optional.of(new Common(length, MEDIAN_ERROR * spread / Math.sqrt(good.length)));
	}
}
