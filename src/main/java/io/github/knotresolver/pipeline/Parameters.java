package io.github.knotresolver.pipeline;

import java.util.Collections;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.SortedSet;
import java.util.TreeSet;

import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.image.Cleaning;
import io.github.knotresolver.mask.Segmentation;
import io.github.knotresolver.model.UserException;

/**
 * Everything that decides a result, besides the movie itself. The names are
 * those of the command line's options; same movie and same parameters give the
 * same result, whatever the number of threads.
 *
 * @param fixedEnd the clamped end in pixels; empty to have it found
 * @param cleaning how frames are cleaned
 * @param segmentation how the filament's mask is found
 * @param candidates which candidate contours are generated
 * @param resolver how one contour per frame is chosen
 * @param length known length of the filament in pixels; empty to estimate it
 * @param lengthModel whether the length is the same in all frames
 * @param refine whether the filament is fitted to the image, sub-pixel
 * @param frames 1-based frames to resolve; empty for all
 * @param ignoreFrames 1-based frames to leave out
 * @param corrections contours the user gave, by 1-based frame, fixed end first,
 *          in pixels
 * @param threads number of threads, at least 1
 */
public record Parameters(Optional<Point> fixedEnd, Cleaning cleaning, Segmentation segmentation,
	CandidateMethod candidates, ResolverMethod resolver, OptionalDouble length,
	LengthModel lengthModel, boolean refine, SortedSet<Integer> frames,
	SortedSet<Integer> ignoreFrames, Map<Integer, Polyline> corrections, int threads) {

	/** Which candidate contours are generated from a frame's graph. */
	public enum CandidateMethod {
		/** The published method: simple paths near the template. */
		PAPER,
		/** Trails that may use a segment twice. */
		TRAILS
	}

	/** How one contour per frame is chosen among the candidates. */
	public enum ResolverMethod {
		/** The published method: nearest to the last contour by DTW. */
		PAPER,
		/** The cheapest way through the whole movie. */
		MOVIE
	}

	/** Whether the filament keeps its length. */
	public enum LengthModel {
		/** The same in all frames. */
		CONSTANT,
		/** Growing or shrinking. */
		FREE
	}

	/** No fixed end told, automatic threshold, our candidates and resolver. */
	public static final Parameters DEFAULT = new Parameters(Optional.empty(), Cleaning.DEFAULT,
		Segmentation.DEFAULT, CandidateMethod.TRAILS, ResolverMethod.MOVIE, OptionalDouble.empty(),
		LengthModel.CONSTANT, true, new TreeSet<>(), new TreeSet<>(), Map.of(),
		Runtime.getRuntime().availableProcessors());

	public Parameters {
		Objects.requireNonNull(candidates);
		Objects.requireNonNull(resolver);
		Objects.requireNonNull(lengthModel);
		if (length.isPresent() && !(length.getAsDouble() > 0))
			throw new UserException(
				"length must be above 0, but is " + length.getAsDouble() + ".");
		if (threads < 1)
			throw new UserException(
				"threads must be at least 1, but is " + threads + ".");
		frames = Collections.unmodifiableSortedSet(new TreeSet<>(frames));
		ignoreFrames = Collections.unmodifiableSortedSet(new TreeSet<>(ignoreFrames));
		corrections = Map.copyOf(corrections);
	}

	/**
	 * @return whether this is the published method from end to end: then Otsu's threshold
	 *         is taken as published
	 */
	public boolean isPublished() {
		return candidates == CandidateMethod.PAPER && resolver == ResolverMethod.PAPER;
	}
}
