package io.github.knotresolver.evaluate.like;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;

import org.apache.commons.math3.stat.descriptive.rank.Median;

import io.github.knotresolver.evaluate.like.LikeResult.LikeMotion;
import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.progress.Progress;
import io.github.knotresolver.progress.Workers;
import io.github.knotresolver.simulate.FilamentProperties.Clamp;
import io.github.knotresolver.simulate.FilamentSimulator;

/**
 * Finds motor density, time scale and start of a simulation whose motion
 * resembles that of a user's filament.
 * <p>
 * Two simulations for each of six densities are enough: they are recorded finely in
 * time, and every time scale and start is a way to read the recordings. The tip
 * of a filament over motors moves about as fast as they walk whatever their
 * density, so the user's tip tells the time scale to begin with. The reading that
 * is least unlike ({@link Motion#unlike}) wins. Seeded: the same result always.
 */
final class MotionSearch {

	/** Motors per µm²: the published range and fewer. */
	private static final double[] DENSITIES = {3, 6, 12, 25, 50, 100};

	/** Speed of the tip over motors at their default speed, µm/s. */
	private static final double TIP_SPEED = 0.1;

	/** Recorded frames in the expected interval, and readings of the recording. */
	private static final int FINE = 6;
	private static final int[] STRIDES = {2, 3, 4, 5, 6, 7, 8, 9, 11, 13};

	/** Simulated time before the first frame, s. */
	private static final double[] STARTS = {0, 20, 40, 60, 80, 100, 130, 160, 200, 240};

	/** Recordings of each density, and how far apart their seeds are. */
	private static final int RECORDINGS = 2;
	private static final long SEEDS_APART = 1_000_003;

	private static final int FEWEST_FRAMES = 10, MOST_FRAMES = 10_000;

	/** Longest recording in s; longer movies are compared by their first part. */
	private static final double LONGEST = 500;

	/** The user's filament turns about its clamp if its direction there varies by more, rad. */
	private static final double TURNS = 1.5;

	/** Length from the fixed end that has the clamp's direction, in pixels. */
	private static final double BASE = 8;

	private final LikeSource source;
	private final Motion wanted;
	private final double width;
	private final double length;
	private final Clamp clamp;
	private final double expected;

	/**
	 * @param source the user's result
	 * @param wanted its motion
	 * @param width of its line in pixels
	 */
	MotionSearch(final LikeSource source, final Motion wanted, final double width) {
		this.source = source;
		this.wanted = wanted;
		this.width = width;
		final List<Polyline> contours = source.contours().stream().flatMap(Optional::stream)
			.toList();
		length = new Median().evaluate(contours.stream().mapToDouble(Polyline::length).toArray())
			* source.pixelSize();
		clamp = turning(contours) > TURNS ? Clamp.PIVOT : Clamp.DIRECTION;
		expected = Math.max(0.02, wanted.tipStep() * source.pixelSize() / TIP_SPEED);
	}

	/** @return how far the direction at the clamp turns over the movie, in rad */
	private static double turning(final List<Polyline> contours) {
		double angle = 0, least = 0, most = 0, before = Double.NaN;
		for (final Polyline contour : contours) {
			final double now = direction(contour);
			if (!Double.isNaN(before))
				angle += Math.IEEEremainder(now - before, 2 * Math.PI);
			before = now;
			least = Math.min(least, angle);
			most = Math.max(most, angle);
		}
		return most - least;
	}

	/** @return the direction at the fixed end in rad */
	static double direction(final Polyline contour) {
		final Point from = contour.first(), to = contour.at(Math.min(BASE, contour.length()));
		return StrictMath.atan2(to.y() - from.y(), to.x() - from.x());
	}

	/**
	 * @param seed start of the random numbers
	 * @param workers do one density each
	 * @param progress told; may cancel
	 * @return what to simulate
	 */
	LikeMotion search(final long seed, final Workers workers, final Progress progress) {
		return workers
			.map("Searching for the motion", progress, DENSITIES.length,
				i -> best(DENSITIES[i], seed, progress.silent()))
			.stream().min(Comparator.comparingDouble(Reading::unlike)).orElseThrow().motion();
	}

	/** A way to read recordings, and how unlike the user's motion it is. */
	private record Reading(LikeMotion motion, double unlike) {
	}

	private Reading best(final double density, final long seed, final Progress progress) {
		final double step = expected / FINE;
		final List<List<Motion.Shape>> recordings = new ArrayList<>();
		for (int i = 0; i < RECORDINGS; i++)
			recordings.add(record(density, step, seed + SEEDS_APART * i, progress));
		final List<Reading> readings = new ArrayList<>();
		for (final int stride : STRIDES)
			for (final double start : STARTS)
				readings
					.add(new Reading(new LikeMotion(length, clamp, density, stride * step, start),
						recordings.stream()
							.mapToDouble(r -> unlike(r, (int) Math.rint(start / step), stride))
							.sum()));
		return readings.stream().min(Comparator.comparingDouble(Reading::unlike)).orElseThrow();
	}

	private List<Motion.Shape> record(final double density, final double step, final long seed,
		final Progress progress) {
		final double last = STARTS[STARTS.length - 1];
		final double time = Math.min(LONGEST,
			last + Math.max(last, source.movie().size() * expected * 1.5));
		final int recorded = (int) Math.max(2, Math.min(MOST_FRAMES, Math.ceil(time / step)));
		return new FilamentSimulator(
			new LikeMotion(length, clamp, density, step, 0).simulation(recorded, seed))
			.run(progress).curves().stream()
			.map(c -> Motion.Shape.of(c, width * source.pixelSize())).toList();
	}

	/** How unlike the frames from one on, every so many, are; infinite if there are too few. */
	private double unlike(final List<Motion.Shape> recording, final int from, final int stride) {
		final List<Motion.Shape> frames = new ArrayList<>();
		for (int i = from; i < recording.size()
			&& frames.size() < source.movie().size(); i += stride)
			frames.add(recording.get(i));
		if (frames.size() < Math.min(source.movie().size(), FEWEST_FRAMES))
			return Double.POSITIVE_INFINITY;
		return Motion.ofShapes(frames).inPixels(source.pixelSize()).unlike(wanted);
	}
}
