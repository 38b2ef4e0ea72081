package io.github.knotresolver.model;

import java.util.List;
import java.util.Objects;
import java.util.Optional;

import io.github.knotresolver.geometry.Crossings;
import io.github.knotresolver.geometry.Polyline;

/**
 * What was found of one filament in one frame.
 *
 * @param frame 1-based number of the frame in the movie
 * @param status what became of it
 * @param reason why it is not simply resolved, one sentence; empty if there is
 *          nothing to say
 * @param contour the contour in pixels, fixed end first; present if and only if
 *          the status is {@code RESOLVED} or {@code CORRECTED}
 * @param junctions number of junctions of the skeleton
 * @param candidates number of contours that were compared
 * @param cost price of the chosen one (smaller is better); NaN if there is none
 * @param confidence 0..1: how sure it is that no other contour is right; NaN if
 *          there is no contour
 * @param visible share of the filament's length inside the picture, 0..1
 * @param alternatives other contours that were considered, cheapest first; may
 *          be empty
 */
public record Observation(int frame, FrameStatus status, String reason, Optional<Polyline> contour,
	int junctions, int candidates, double cost, double confidence, double visible,
	List<Alternative> alternatives) {

	/** The reason of a frame whose contour the user gave as a whole. */
	public static final String GIVEN = "Given by the user.";

	/** The reason of a frame that is {@code LOST}. */
	public static final String NOT_FOUND = "No filament was found in this frame.";

	/** A contour with more confidence than this is believed: nine of ten such contours are right, and a person need not look. */
	public static final double SURE = 0.9;

	public Observation {
		if (frame < 1)
			throw new IllegalArgumentException(
				"Frames count from 1, but this is frame " + frame + ".");
		Objects.requireNonNull(reason);
		if (!(visible >= 0 && visible <= 1))
			throw new IllegalArgumentException(
				"The visible share must be from 0 to 1, but is " + visible + ".");
		alternatives = List.copyOf(alternatives);
		final boolean expected = status == FrameStatus.RESOLVED || status == FrameStatus.CORRECTED;
		if (contour.isPresent() != expected)
			throw new IllegalArgumentException("Frame " + frame + " is " + status.label()
				+ (expected ? " but has no contour." : " but has a contour."));
	}

	/**
	 * A filament that lies inside the picture as a whole, without alternatives.
	 *
	 * @param frame 1-based number of the frame in the movie
	 * @param status what became of it
	 * @param reason why it is not simply resolved, one sentence; may be empty
	 * @param contour the contour in pixels, fixed end first
	 * @param junctions number of junctions of the skeleton
	 * @param candidates number of contours that were compared
	 * @param cost price of the chosen one; NaN if there is none
	 * @param confidence 0..1; NaN if there is no contour
	 */
	public Observation(final int frame, final FrameStatus status, final String reason,
		final Optional<Polyline> contour, final int junctions, final int candidates,
		final double cost, final double confidence) {
		this(frame, status, reason, contour, junctions, candidates, cost, confidence, 1, List.of());
	}

	/**
	 * A frame without a contour.
	 *
	 * @param frame 1-based number of the frame
	 * @param status any but {@code RESOLVED} and {@code CORRECTED}
	 * @param reason why, one sentence
	 * @return the observation
	 */
	public static Observation without(final int frame, final FrameStatus status,
		final String reason) {
		return new Observation(frame, status, reason, Optional.empty(), 0, 0, Double.NaN,
			Double.NaN);
	}

	/**
	 * @param better another contour for this frame, in pixels
	 * @return the same with that contour
	 */
	public Observation withContour(final Polyline better) {
		return new Observation(frame, status, reason, Optional.of(better), junctions, candidates,
			cost, confidence, visible, alternatives);
	}

	/**
	 * @param better another confidence, 0..1
	 * @param why one sentence; may be empty
	 * @return the same with that confidence and reason
	 */
	public Observation withConfidence(final double better, final String why) {
		return new Observation(frame, status, why, contour, junctions, candidates, cost, better,
			visible, alternatives);
	}

	/**
	 * @param limit the most that can be believed, 0..1
	 * @param why one sentence, in case nothing else has lowered the confidence so far
	 * @return the same, no surer than that; a reason is given if it is not believed then.
	 *         What the user said stays as it was said
	 */
	public Observation atMost(final double limit, final String why) {
		return stays(limit)
			? this
			: withConfidence(limit, limit > SURE || !reason.isEmpty() ? reason : why);
	}

	/**
	 * @param limit the most that can be believed, 0..1
	 * @param why one sentence, which counts more than what has lowered the confidence so far
	 * @return the same, no surer than that, with that reason if it was. What the user said
	 *         stays as it was said
	 */
	public Observation doubted(final double limit, final String why) {
		return stays(limit) ? this : withConfidence(limit, why);
	}

	private boolean stays(final double limit) {
		return status != FrameStatus.RESOLVED || !(confidence > limit);
	}

	/**
	 * @param share share of the filament's length inside the picture, 0..1
	 * @return the same with that share
	 */
	public Observation withVisible(final double share) {
		return new Observation(frame, status, reason, contour, junctions, candidates, cost,
			confidence, share, alternatives);
	}

	/**
	 * @param others other contours that were considered, cheapest first
	 * @return the same with those alternatives
	 */
	public Observation withAlternatives(final List<Alternative> others) {
		return new Observation(frame, status, reason, contour, junctions, candidates, cost,
			confidence, visible, others);
	}

	/** @return how often the contour crosses itself; 0 without a contour */
	public int crossings() {
		return contour.map(c -> Crossings.of(c).size()).orElse(0);
	}
}
