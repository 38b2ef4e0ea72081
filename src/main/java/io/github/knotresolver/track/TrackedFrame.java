package io.github.knotresolver.track;

import java.util.Objects;
import java.util.Optional;

import io.github.knotresolver.geometry.Crossings;
import io.github.knotresolver.geometry.Polyline;

/**
 * What was found in one frame.
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
 */
public record TrackedFrame(int frame, FrameStatus status, String reason, Optional<Polyline> contour,
	int junctions, int candidates, double cost, double confidence) {

	public TrackedFrame {
		if (frame < 1)
			throw new IllegalArgumentException(
				"Frames count from 1, but this is frame " + frame + ".");
		Objects.requireNonNull(reason);
		final boolean expected = status == FrameStatus.RESOLVED || status == FrameStatus.CORRECTED;
		if (contour.isPresent() != expected)
			throw new IllegalArgumentException("Frame " + frame + " is " + status.label()
				+ (expected ? " but has no contour." : " but has a contour."));
	}

	/**
	 * A frame without a contour.
	 *
	 * @param frame 1-based number of the frame
	 * @param status any but {@code RESOLVED} and {@code CORRECTED}
	 * @param reason why, one sentence
	 * @return the frame
	 */
	public static TrackedFrame without(final int frame, final FrameStatus status,
		final String reason) {
		return new TrackedFrame(frame, status, reason, Optional.empty(), 0, 0, Double.NaN,
			Double.NaN);
	}

	/**
	 * @param better another contour for this frame, in pixels
	 * @return the same frame with that contour
	 */
	public TrackedFrame withContour(final Polyline better) {
		return new TrackedFrame(frame, status, reason, Optional.of(better), junctions, candidates,
			cost, confidence);
	}

	/** @return how often the contour crosses itself; 0 without a contour */
	public int crossings() {
		return contour.map(c -> Crossings.of(c).size()).orElse(0);
	}
}
