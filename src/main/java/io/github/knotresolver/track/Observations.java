package io.github.knotresolver.track;

import java.util.Optional;

import io.github.knotresolver.geometry.Polyline;
import io.github.knotresolver.model.FrameStatus;
import io.github.knotresolver.model.Observation;

/** What resolvers say about frames that are not simply resolved. */
public final class Observations {

	private Observations() {
	}

	/**
	 * @param frame a frame
	 * @param contour what the user gave for it, in pixels
	 * @return the frame with that contour
	 */
	public static Observation corrected(final FrameGraph frame, final Polyline contour) {
		return new Observation(frame.frame(), FrameStatus.CORRECTED, "Given by the user.",
			Optional.of(contour), frame.junctions(), 1, 0, 1);
	}

	/**
	 * @param frame a frame without the filament
	 * @return the frame, lost
	 */
	public static Observation lost(final FrameGraph frame) {
		return Observation.without(frame.frame(), FrameStatus.LOST,
			"No filament was found in this frame.");
	}

	/**
	 * @param frame a frame whose skeleton gives no contour
	 * @return the frame, unresolved
	 */
	public static Observation withoutCandidates(final FrameGraph frame) {
		return Observation.without(frame.frame(), FrameStatus.UNRESOLVED,
			"The skeleton is too small to hold a contour.");
	}

	/**
	 * @param limited whether a search hit its limit
	 * @return a sentence that says so; empty if it did not
	 */
	public static String limitReason(final boolean limited) {
		return limited
			? "The search hit a limit: a better contour may have been missed; if it is wrong, draw the frame as a correction."
			: "";
	}
}
