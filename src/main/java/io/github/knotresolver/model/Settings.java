package io.github.knotresolver.model;

import java.util.ArrayList;
import java.util.Collection;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.SortedMap;
import java.util.SortedSet;
import java.util.TreeMap;
import java.util.TreeSet;

import io.github.knotresolver.geometry.Point;
import io.github.knotresolver.geometry.Polyline;

/**
 * Everything that decides a result, besides the movie itself. The names are
 * those of the command line's options; same movie and same settings give the
 * same result, whatever the number of threads. Change one with
 * {@code settings.edit().refine(false).build()}.
 *
 * @param fixedEnd the clamped end in pixels; empty to have it found
 * @param region where the filament is searched; empty for everywhere
 * @param cleaning how frames are cleaned
 * @param segmentation how the filament's mask is found
 * @param candidates which candidate contours are generated
 * @param resolver how one contour per frame is chosen
 * @param length known length of the filament in pixels; empty to estimate it
 * @param lengthModel whether the length is the same in all frames
 * @param refine whether the filament is fitted to the image, sub-pixel
 * @param frames 1-based frames to resolve; empty for all
 * @param ignoreFrames 1-based frames to leave out
 * @param constraints what the user said about frames, in the order of frames
 * @param filaments how many filaments are delivered
 * @param anchor whether filaments are held at one end
 * @param threads number of threads, at least 1
 */
public record Settings(Optional<Point> fixedEnd, Optional<Region> region, Cleaning cleaning,
	Segmentation segmentation, CandidateMethod candidates, ResolverMethod resolver,
	OptionalDouble length, LengthModel lengthModel, boolean refine, SortedSet<Integer> frames,
	SortedSet<Integer> ignoreFrames, List<Constraint> constraints, FilamentChoice filaments,
	AnchorChoice anchor, int threads) {

	/** No fixed end told, automatic threshold, our candidates and resolver. */
	public static final Settings DEFAULT = new Builder().build();

	// Evidence has no parameters: in the published method, and where something is said about
	// threshold, active contour or Laplacian of Gaussian, those make the mask instead.
	public Settings {
		Objects.requireNonNull(fixedEnd);
		Objects.requireNonNull(region);
		Objects.requireNonNull(candidates);
		Objects.requireNonNull(resolver);
		Objects.requireNonNull(lengthModel);
		Objects.requireNonNull(filaments);
		Objects.requireNonNull(anchor);
		if (segmentation.steps() == Segmentation.Steps.EVIDENCE
			&& (isPublished(candidates, resolver) || cleaning.enhances()
				|| !segmentation.isAutomatic()))
			segmentation = segmentation.withSteps(Segmentation.Steps.BOTH);
		if (length.isPresent() && !(length.getAsDouble() > 0))
			throw new UserException(
				"length must be above 0, but is " + ShownNumber.of(length.getAsDouble()) + ".");
		if (threads < 1)
			throw new UserException("threads must be at least 1, but is " + threads + ".");
		frames = Collections.unmodifiableSortedSet(new TreeSet<>(frames));
		ignoreFrames = Collections.unmodifiableSortedSet(new TreeSet<>(ignoreFrames));
		constraints = Constraint.sorted(constraints);
	}

	/**
	 * @return whether this is the published method from end to end: then Otsu's threshold
	 *         is taken as published
	 */
	public boolean isPublished() {
		return isPublished(candidates, resolver);
	}

	private static boolean isPublished(final CandidateMethod candidates,
		final ResolverMethod resolver) {
		return candidates == CandidateMethod.PAPER && resolver == ResolverMethod.PAPER;
	}

	/**
	 * @return whether every filament of the field is followed: what works on skeletons knows
	 *         one
	 */
	public boolean deliversAll() {
		final boolean all = switch (filaments) {
			case ALL -> true;
			case ONE -> false;
			case AUTO -> fixedEnd.isEmpty() && region.isEmpty();
		};
		return all && fitsTrails();
	}

	/** @return whether filaments are fitted to the picture, from trails, by the whole movie */
	public boolean fitsTrails() {
		return refine && resolver == ResolverMethod.MOVIE && candidates == CandidateMethod.TRAILS;
	}

	/** @return the whole contours that the user gave for filament 1, by 1-based frame, in pixels */
	public SortedMap<Integer, Polyline> corrections() {
		final SortedMap<Integer, Polyline> contours = new TreeMap<>();
		constraints.stream().filter(c -> c.kind() == Constraint.Kind.CONTOUR && c.filament() == 1)
			.forEach(c -> contours.put(c.frame(), c.shape()));
		return contours;
	}

	/** @return these settings, to be changed one by one; this object stays as it is */
	public Builder edit() {
		return new Builder().fixedEnd(fixedEnd).region(region).cleaning(cleaning)
			.segmentation(segmentation).candidates(candidates).resolver(resolver).length(length)
			.lengthModel(lengthModel).refine(refine).frames(frames).ignoreFrames(ignoreFrames)
			.constraints(constraints).filaments(filaments).anchor(anchor).threads(threads);
	}

	/** Settings in the making, each with its default; what is not allowed is told at the end. */
	public static final class Builder {

		private Optional<Point> fixedEnd = Optional.empty();
		private Optional<Region> region = Optional.empty();
		private Cleaning cleaning = Cleaning.DEFAULT;
		private Segmentation segmentation = Segmentation.DEFAULT;
		private CandidateMethod candidates = CandidateMethod.TRAILS;
		private ResolverMethod resolver = ResolverMethod.MOVIE;
		private OptionalDouble length = OptionalDouble.empty();
		private LengthModel lengthModel = LengthModel.AUTO;
		private boolean refine = true;
		private Collection<Integer> frames = new TreeSet<>();
		private Collection<Integer> ignoreFrames = new TreeSet<>();
		private Collection<Constraint> constraints = List.of();
		private FilamentChoice filaments = FilamentChoice.AUTO;
		private AnchorChoice anchor = AnchorChoice.AUTO;
		private int threads = Runtime.getRuntime().availableProcessors();

		/**
		 * @return the settings
		 * @throws UserException if a value is not allowed, in one sentence
		 */
		public Settings build() {
			return new Settings(fixedEnd, region, cleaning, segmentation, candidates, resolver,
				length, lengthModel, refine, new TreeSet<>(frames), new TreeSet<>(ignoreFrames),
				Constraint.sorted(constraints), filaments, anchor, threads);
		}

		/**
		 * @param value the clamped end in pixels; empty to have it found
		 * @return this
		 */
		public Builder fixedEnd(final Optional<Point> value) {
			fixedEnd = value;
			return this;
		}

		/**
		 * @param value where the filament is searched; empty for everywhere
		 * @return this
		 */
		public Builder region(final Optional<Region> value) {
			region = value;
			return this;
		}

		/**
		 * @param value how frames are cleaned
		 * @return this
		 */
		public Builder cleaning(final Cleaning value) {
			cleaning = value;
			return this;
		}

		/**
		 * @param value how the filament's mask is found
		 * @return this
		 */
		public Builder segmentation(final Segmentation value) {
			segmentation = value;
			return this;
		}

		/**
		 * @param value which candidate contours are generated
		 * @return this
		 */
		public Builder candidates(final CandidateMethod value) {
			candidates = value;
			return this;
		}

		/**
		 * @param value how one contour per frame is chosen
		 * @return this
		 */
		public Builder resolver(final ResolverMethod value) {
			resolver = value;
			return this;
		}

		/**
		 * @param value known length of the filament in pixels; empty to estimate it
		 * @return this
		 */
		public Builder length(final OptionalDouble value) {
			length = value;
			return this;
		}

		/**
		 * @param value whether the length is the same in all frames
		 * @return this
		 */
		public Builder lengthModel(final LengthModel value) {
			lengthModel = value;
			return this;
		}

		/**
		 * @param value whether the filament is fitted to the image, sub-pixel
		 * @return this
		 */
		public Builder refine(final boolean value) {
			refine = value;
			return this;
		}

		/**
		 * @param value 1-based frames to resolve; empty for all
		 * @return this
		 */
		public Builder frames(final Collection<Integer> value) {
			frames = value;
			return this;
		}

		/**
		 * @param value 1-based frames to leave out
		 * @return this
		 */
		public Builder ignoreFrames(final Collection<Integer> value) {
			ignoreFrames = value;
			return this;
		}

		/**
		 * @param value what the user said about frames
		 * @return this
		 */
		public Builder constraints(final Collection<Constraint> value) {
			constraints = value;
			return this;
		}

		/**
		 * @param value whole contours of filament 1 by 1-based frame, fixed end first, in
		 *          pixels; nothing else is said then
		 * @return this
		 */
		public Builder corrections(final Map<Integer, Polyline> value) {
			final List<Constraint> contours = new ArrayList<>();
			value.forEach((frame, contour) -> contours.add(Constraint.contour(frame, contour)));
			return constraints(contours);
		}

		/**
		 * @param value how many filaments are delivered
		 * @return this
		 */
		public Builder filaments(final FilamentChoice value) {
			filaments = value;
			return this;
		}

		/**
		 * @param value whether filaments are held at one end
		 * @return this
		 */
		public Builder anchor(final AnchorChoice value) {
			anchor = value;
			return this;
		}

		/**
		 * @param value number of threads, at least 1
		 * @return this
		 */
		public Builder threads(final int value) {
			threads = value;
			return this;
		}
	}

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
		/** The same in all frames, unless the movie says that it changes. */
		AUTO,
		/** The same in all frames. */
		CONSTANT,
		/** What each frame says. */
		FREE
	}

	/** Whether filaments have an end that is held. */
	public enum AnchorChoice {
		/** The movie tells, for each filament. */
		AUTO,
		/** All filaments are held at one end. */
		CLAMPED,
		/** No filament is held. */
		FREE
	}

	/** How many filaments of a movie are delivered. */
	public enum FilamentChoice {
		/** All; the one that is meant where a fixed end, a region or a contour is told. */
		AUTO,
		/** The clamped one: that of the told fixed end, or the most likely one. */
		ONE,
		/** Every filament of the field, clamped or free. */
		ALL
	}
}
