package io.github.knotresolver.track;

import java.util.Arrays;
import java.util.Comparator;
import java.util.Optional;
import java.util.stream.IntStream;
import java.util.stream.Stream;

import io.github.knotresolver.geometry.RobustLine;
import io.github.knotresolver.geometry.RobustStatistics;
import io.github.knotresolver.progress.Cancellation;

/**
 * How long the filament is in every frame: the same in all, growing or shrinking steadily,
 * broken at one frame, both, growing and shrinking by turns, or wandering. What is known are lengths in some frames; of the
 * courses through them that one is taken whose misfit, robust, and number of parameters
 * together are least, as in Schwarz's criterion (doi:10.1214/aos/1176344136); a change must
 * be worth its parameters and be visible.
 *
 * @param lengths in pixels by index of the frame
 * @param others another length that is possible in a frame near a break: as it was before, or
 *          as it is after; NaN elsewhere
 * @param kind which course it is
 * @param at index of the first frame after a break; 0 if there is none
 */
record LengthCourse(double[] lengths, double[] others, Kind kind, int at) {

	/** The kinds of courses. */
	enum Kind {
		CONSTANT, STEADY, BROKEN, STEADY_AND_BROKEN, PHASES, WANDERING
	}

	/** The same length in all frames. */
	static LengthCourse constant(final double length, final int frames) {
		final double[] lengths = new double[frames];
		Arrays.fill(lengths, length);
		return unbroken(lengths, Kind.CONSTANT);
	}

	private static LengthCourse unbroken(final double[] lengths, final Kind kind) {
		final double[] others = new double[lengths.length];
		Arrays.fill(others, Double.NaN);
		return new LengthCourse(lengths, others, kind, 0);
	}

	/**
	 * Chooses a course.
	 *
	 * @param seen index of each frame in which the length is known, in order
	 * @param known those lengths in pixels
	 * @param frames number of frames
	 * @return the course, one that changes by turns only if it changes otherwise; empty if there are
	 *         too few lengths, or they say that the length is constant
	 */
	static Optional<LengthCourse> changing(final int[] seen, final double[] known,
		final int frames) {
		if (known.length < TrackTuning.COURSE_LENGTHS)
			return Optional.empty();
		final Search search = new Search(seen, known, frames);
		return Optional.of(search.best()).filter(c -> c.kind != Kind.CONSTANT && c.isVisible());
	}

	private boolean isVisible() {
		final double[] sorted = lengths.clone();
		Arrays.sort(sorted);
		return sorted[sorted.length - 1] / sorted[0] - 1 > TrackTuning.LENGTH_CHANGE;
	}

	/** The same in all frames: as long as it is in the middle of them. */
	LengthCourse levelled() {
		return constant(RobustStatistics.median(lengths, 0), lengths.length);
	}

	/** The shortest that a course may be, of lengths that were seen: a tenth of the least. */
	static double least(final double[] seen) {
		return 0.1 * Arrays.stream(seen).min().orElse(1);
	}

	/** Length in a frame in pixels. */
	double of(final int index) {
		return lengths[index];
	}

	/** Whether a length of a frame near a break is that of before or after. */
	boolean isOpen(final int index) {
		return Double.isFinite(others[index]);
	}

	/** The possible length of a frame that is nearest to another, in pixels. */
	double nearest(final int index, final double length) {
		return isOpen(index) && Math.abs(others[index] - length) < Math.abs(lengths[index] - length)
			? others[index]
			: lengths[index];
	}

	/** The same with what was found in frames near the break, in pixels. */
	LengthCourse settled(final double[] found) {
		if (at == 0)
			return this;
		final double[] settled = lengths.clone();
		int first = at;
		for (int t = 0; t < settled.length; t++)
			if (isOpen(t))
				settled[t] = nearest(t, found[t]);
		while (first > 1 && isOpen(first - 1) && settled[first - 1] != lengths[first - 1])
			first--;
		while (first < settled.length && isOpen(first) && settled[first] != lengths[first])
			first++;
		return new LengthCourse(settled, others, kind, first);
	}

	/** Change of the length per frame in pixels, away from a break. */
	double rate() {
		final int n = lengths.length;
		if (n < 2)
			return 0;
		final double whole = lengths[n - 1] - lengths[0];
		final double jump = at == 0 ? 0 : lengths[at] - lengths[at - 1];
		return (whole - jump) / (n - 1 - (at == 0 ? 0 : 1));
	}

	/** Tries all courses. */
	private static final class Search {

		private final int[] seen;
		private final double[] known;
		private final int frames;
		private final double error;

		Search(final int[] seen, final double[] known, final int frames) {
			this.seen = seen;
			this.known = known;
			this.frames = frames;
			error = Math.max(TrackTuning.LENGTH_ERROR * RobustStatistics.median(known, 0), noise());
		}

		/** Standard deviation of a length from the mean of its neighbours in time. */
		private double noise() {
			final double[] off = IntStream.range(1, known.length - 1)
				.mapToDouble(i -> Math.abs(known[i] - 0.5 * (known[i - 1] + known[i + 1])))
				.toArray();
			return RobustStatistics.MAD_TO_SD * RobustStatistics.median(off, 0) / Math.sqrt(1.5);
		}

		private Stream<LengthCourse> broken() {
			return IntStream
				.rangeClosed(TrackTuning.BESIDE_BREAK, known.length - TrackTuning.BESIDE_BREAK)
				.boxed().flatMap(k -> Stream.of(broken(k, false), broken(k, true)));
		}

		/** A length that changes at all may do so by turns. */
		LengthCourse best() {
			final LengthCourse first = Stream
				.concat(Stream.of(constant(RobustStatistics.median(known, 0), frames), steady(),
					wandering()), broken())
				.min(Comparator.comparingDouble(c -> price(c, 0, false))).orElseThrow();
			if (first.kind == Kind.CONSTANT)
				return first;
			final LengthPhases phases = LengthPhases.of(seen, known, frames, error,
				2 * TrackTuning.PARAMETER * Math.log(known.length));
			final LengthCourse other = unbroken(phases.lengths(), Kind.PHASES);
			return price(other, phases.turns(), true) < price(first, 0, true) ? other : first;
		}

		/**
		 * @param together whether lengths that are far off together, and not by chance each, count
		 *          more than single ones
		 */
		private double price(final LengthCourse course, final int turns, final boolean together) {
			final double[] off = new double[known.length];
			for (int i = 0; i < off.length; i++)
				off[i] = (known[i] - course.lengths[seen[i]]) / error;
			double sum = 0;
			for (int i = 0; i < off.length; i++) {
				final double most = TrackTuning.LENGTH_OUTLIER
					* (together && isOneOfThree(off, i) ? 2 : 1);
				final double least = Math.min(most, Math.abs(off[i]));
				sum += 0.5 * least * least;
			}
			return sum
				+ TrackTuning.PARAMETER * Math.log(known.length) * parameters(course.kind, turns);
		}

		/** Whether a length and those before and after it are all too long, or all too short. */
		private static boolean isOneOfThree(final double[] off, final int i) {
			if (i == 0 || i == off.length - 1)
				return false;
			final double sign = Math.signum(off[i]);
			return Math.min(sign * off[i],
				Math.min(sign * off[i - 1], sign * off[i + 1])) > TrackTuning.LENGTH_OUTLIER;
		}

		private double parameters(final Kind kind, final int turns) {
			return switch (kind) {
				case CONSTANT -> 1;
				case STEADY -> 2;
				case BROKEN -> 3;
				case STEADY_AND_BROKEN -> 5;
				case PHASES -> 2 + 2 * turns;
				case WANDERING -> 6 + frames / TrackTuning.WANDERING;
			};
		}

		private LengthCourse steady() {
			return unbroken(fill(new double[frames], 0, frames, line(0, known.length)),
				Kind.STEADY);
		}

		private LengthCourse broken(final int first, final boolean steady) {
			Cancellation.check();
			final int at = (seen[first - 1] + seen[first] + 1) / 2;
			final RobustLine before = steady ? line(0, first) : level(0, first);
			final RobustLine after = steady
				? line(first, known.length)
				: level(first, known.length);
			final double[] lengths = new double[frames], others = new double[frames];
			fill(lengths, 0, at, before);
			fill(lengths, at, frames, after);
			Arrays.fill(others, Double.NaN);
			fill(others, seen[first - 1] + 1, at, after);
			fill(others, at, seen[first], before);
			return new LengthCourse(lengths, others, steady ? Kind.STEADY_AND_BROKEN : Kind.BROKEN,
				at);
		}

		private LengthCourse wandering() {
			final double[] all = new double[frames];
			Arrays.fill(all, Double.NaN);
			for (int i = 0; i < known.length; i++)
				all[seen[i]] = known[i];
			final double[] errors = new double[frames];
			Arrays.fill(errors, error);
			return unbroken(RandomWalk.through(all, errors).mean(), Kind.WANDERING);
		}

		private RobustLine level(final int from, final int to) {
			return new RobustLine(RobustStatistics.median(Arrays.copyOfRange(known, from, to), 0),
				0);
		}

		private RobustLine line(final int from, final int to) {
			return RobustLine.through(IntStream.range(from, to).mapToDouble(i -> seen[i]).toArray(),
				Arrays.copyOfRange(known, from, to));
		}

		private double[] fill(final double[] lengths, final int from, final int to,
			final RobustLine line) {
			final double least = least(known);
			for (int t = from; t < to; t++)
				lengths[t] = Math.max(least, line.at(t));
			return lengths;
		}
	}
}
